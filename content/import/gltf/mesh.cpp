#include "content/import/gltf/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "content/import/gltf/accessor.h"
#include "content/import/gltf/draco.h"

namespace docent::import::gltf {
namespace {

enum class Mode : std::uint8_t { Points, Lines, LineLoop, LineStrip, Triangles, Strip, Fan };

/// One primitive while it is read: where each attribute comes from.
class PrimitiveReader {
 public:
  PrimitiveReader(Source& source, Part part, std::size_t joints,
                  const std::vector<Material>& materials)
      : source_{source}, part_{std::move(part)}, joints_{joints}, materials_{materials} {}

  Primitive read(Mode mode) {
    unpack();
    primitive_.material = part_["material"].index_or_none(materials_.size(), "material");
    take_positions();
    take_indices(mode);
    take_normals();
    take_texture_places();
    take_colours();
    if (joints_ > 0) take_joints();
    return std::move(primitive_);
  }

 private:
  Part attribute(const char* name) const { return part_["attributes"][name]; }

  void unpack() {
    const Part extensions = part_["extensions"];
    if (!extensions.is_there()) return;
    const Part packed = extensions["KHR_draco_mesh_compression"];
    if (!packed.is_there()) return;
    std::vector<std::uint64_t> ids;
    for (const std::string& key : packed["attributes"].keys())
      ids.push_back(packed["attributes"][key].whole(0, UINT32_MAX));
    const std::size_t corners =
        count_of(source_, part_["indices"].whole(0, UINT32_MAX), part_["indices"]);
    source_.count_corners(corners, part_);
    const Source::View view = source_.view(packed["bufferView"].whole(0, UINT32_MAX));
    draco_ = unpack_draco(view.bytes, ids, corners, packed);
    is_draco_ = true;
  }

  /// The numbers of an attribute, wherever they lie; empty where the primitive does not have it.
  Numbers numbers_of(const char* name) {
    const Part part = attribute(name);
    if (!part.is_there()) return {};
    if (is_draco_) {
      const Part id = part_["extensions"]["KHR_draco_mesh_compression"]["attributes"][name];
      if (id.is_there())
        for (const DracoMesh::Attribute& a : draco_.attributes)
          if (a.id == id.whole(0, UINT32_MAX))
            return unpacked_numbers(a, source_.root()["accessors"].at(part.whole(0, UINT32_MAX)));
    }
    Numbers numbers = read_numbers(source_, part.whole(0, UINT32_MAX), part);
    if (primitive_.position.empty()) return numbers;
    if (numbers.count != primitive_.position.size())
      part.fail(fmt::format("has {} elements, and POSITION has {}", numbers.count,
                            primitive_.position.size()));
    return numbers;
  }

  /// What Draco unpacked, as shares where the accessor says so (KHR_mesh_quantization).
  Numbers unpacked_numbers(const DracoMesh::Attribute& a, const Part& accessor) const {
    Numbers numbers{.components = a.components, .count = draco_.vertices, .value = a.value};
    if (a.is_normalised || !accessor["normalized"].flag_or(false)) return numbers;
    constexpr std::array largest{127.0F, 255.0F, 32767.0F, 65535.0F};
    const std::uint64_t type = accessor["componentType"].whole(5120, 5126) - 5120;
    for (float& value : numbers.value)
      if (type < largest.size()) value = std::max(value / largest[type], -1.0F);
    return numbers;
  }

  void take_positions() {
    const Part part = attribute("POSITION");
    if (!part.is_there()) part.fail("is missing");
    if (!is_draco_)
      source_.count_vertices(count_of(source_, part.whole(0, UINT32_MAX), part), part);
    else
      source_.count_vertices(draco_.vertices, part);
    const Numbers numbers = numbers_of("POSITION");
    if (numbers.components != 3) part.fail("must be of type VEC3");
    for (std::size_t i = 0; i < numbers.count; ++i)
      primitive_.position.emplace_back(numbers.value[3 * i], numbers.value[3 * i + 1],
                                       numbers.value[3 * i + 2]);
    constexpr float farthest = 1e6F;
    for (const Vec3& p : primitive_.position)
      if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > farthest)
        part.fail("holds a place that is thousands of kilometres away");
  }

  void take_indices(Mode mode) {
    std::vector<std::uint32_t> list;
    if (is_draco_) {
      list = std::move(draco_.corners);
    } else if (const Part part = part_["indices"]; part.is_there()) {
      const std::uint64_t accessor = part.whole(0, UINT32_MAX);
      source_.count_corners(count_of(source_, accessor, part), part);
      Indices indices = read_indices(source_, accessor, part);
      if (indices.components != 1) part.fail("must be of type SCALAR");
      list = std::move(indices.value);
    } else {
      source_.count_corners(primitive_.position.size(), part_);
      for (std::uint32_t i = 0; i < primitive_.position.size(); ++i) list.push_back(i);
    }
    std::size_t wrong = 0;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      const std::size_t count = primitive_.position.size();
      if (a >= count || b >= count || c >= count)
        ++wrong;
      else if (a != b && b != c && c != a)
        primitive_.indices.insert(primitive_.indices.end(), {a, b, c});
    };
    for (std::size_t i = 0; mode == Mode::Triangles && i + 2 < list.size(); i += 3)
      add(list[i], list[i + 1], list[i + 2]);
    for (std::size_t i = 0; mode == Mode::Strip && i + 2 < list.size(); ++i)
      add(list[i], list[i + 1 + i % 2], list[i + 2 - i % 2]);
    for (std::size_t i = 1; mode == Mode::Fan && i + 1 < list.size(); ++i)
      add(list[0], list[i], list[i + 1]);
    if (wrong > 0)
      source_.warn(
          fmt::format("{}.indices names vertices that are not there; {} triangle{} left "
                      "out",
                      part_.name(), wrong, wrong == 1 ? " is" : "s are"));
  }

  void take_normals() {
    const Numbers numbers = numbers_of("NORMAL");
    if (numbers.components != 3) return;
    for (std::size_t i = 0; i < numbers.count; ++i)
      primitive_.normal.emplace_back(numbers.value[3 * i], numbers.value[3 * i + 1],
                                     numbers.value[3 * i + 2]);
  }

  void take_texture_places() {
    if (primitive_.material < 0) return;
    const Material& material = materials_[static_cast<std::size_t>(primitive_.material)];
    if (material.image < 0) return;
    const Numbers numbers = numbers_of(fmt::format("TEXCOORD_{}", material.uv_set).c_str());
    if (numbers.components != 2) return;
    const float c = std::cos(material.uv_turn), s = std::sin(material.uv_turn);
    for (std::size_t i = 0; i < numbers.count; ++i) {
      const glm::vec2 at =
          material.uv_scale * glm::vec2(numbers.value[2 * i], numbers.value[2 * i + 1]);
      primitive_.uv.push_back(material.uv_offset +
                              glm::vec2(c * at.x + s * at.y, -s * at.x + c * at.y));
    }
  }

  void take_colours() {
    const Numbers numbers = numbers_of("COLOR_0");
    if (numbers.components != 3 && numbers.components != 4) return;
    for (std::size_t i = 0; i < numbers.count; ++i) {
      Vec4 colour{1};
      for (std::size_t c = 0; c < numbers.components; ++c)
        colour[static_cast<int>(c)] =
            std::clamp(numbers.value[i * numbers.components + c], 0.0F, 1.0F);
      primitive_.colour.push_back(colour);
    }
  }

  void take_joints() {
    if (!attribute("JOINTS_0").is_there() || !attribute("WEIGHTS_0").is_there()) return;
    const Numbers joints = numbers_of("JOINTS_0"), weights = numbers_of("WEIGHTS_0");
    if (joints.components != 4) attribute("JOINTS_0").fail("must be of type VEC4");
    if (weights.components != 4) attribute("WEIGHTS_0").fail("must be of type VEC4");
    std::size_t unbound = 0;
    for (std::size_t i = 0; i < joints.count; ++i) {
      std::array<std::uint16_t, 4> joint{};
      Vec4 weight{0};
      for (std::size_t k = 0; k < 4; ++k) {
        const float which = joints.value[4 * i + k];
        const float share = weights.value[4 * i + k];
        if (!(share > 0)) continue;
        if (!(which >= 0) || which >= static_cast<float>(joints_)) {
          ++unbound;
          continue;
        }
        joint[k] = static_cast<std::uint16_t>(which);
        weight[static_cast<int>(k)] = share;
      }
      const float total = weight.x + weight.y + weight.z + weight.w;
      primitive_.joint.push_back(joint);
      primitive_.weight.push_back(total > 0 ? weight / total : Vec4{1, 0, 0, 0});
    }
    if (unbound > 0)
      source_.warn(
          fmt::format("{} names joints that its skin does not have ({} times); these are "
                      "left out",
                      attribute("JOINTS_0").name(), unbound));
  }

  Source& source_;
  Part part_;
  std::size_t joints_;
  const std::vector<Material>& materials_;
  Primitive primitive_;
  DracoMesh draco_;
  bool is_draco_ = false;
};

}  // namespace

Mesh read_mesh(Source& source, std::size_t index, std::size_t joints,
               const std::vector<Material>& materials) {
  const Part part = source.root()["meshes"].at(index);
  const Part primitives = part["primitives"];
  if (primitives.size() == 0) primitives.fail("is empty");
  Mesh mesh{.name = plain_name(part["name"].text_or("")), .primitives = {}};
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const Part one = primitives.at(i);
    const auto mode = static_cast<Mode>(one["mode"].whole_or(4, 6));
    if (mode < Mode::Triangles) {
      source.warn(fmt::format("{} is of points or lines, which nobody would see; it is left out",
                              one.name()));
      continue;
    }
    mesh.primitives.push_back(PrimitiveReader(source, one, joints, materials).read(mode));
  }
  return mesh;
}

}  // namespace docent::import::gltf
