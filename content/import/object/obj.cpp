#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>

#include "content/import/gltf/part.h"
#include "content/import/gltf/texture.h"
#include "content/import/object/kinds.h"
#include "content/import/object/object_text.h"
#include "content/import/object/one_primitive.h"

namespace docent::import::object {
namespace {

constexpr std::size_t most_materials = 1000, most_corners = 1000;

/// A Wavefront OBJ while it is read. Normals are left out: what shows them is made of the shape.
class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& file, const gltf::ReadBeside& beside)
      : lines_{text}, file_{file}, beside_{beside} {}

  gltf::Model read() {
    while (lines_.next()) take_line();
    gltf::Model model = scene_of(std::move(primitives_));
    model.materials = std::move(materials_);
    model.images = std::move(images_);
    model.warnings = faults_.told();
    return model;
  }

 private:
  void take_line() {
    const std::string_view word = lines_.word();
    if (word == "v") return take_vertex();
    if (word == "vt") return take_texture_place();
    if (word == "f") return take_face();
    if (word == "usemtl") use_material(lines_.rest());
    if (word == "mtllib") take_library(lines_.rest());
  }

  void take_vertex() {
    std::array<float, 6> value{};
    std::size_t count = 0;
    bool is_sound = true;
    for (std::string_view word = lines_.word(); !word.empty() && count < value.size();
         word = lines_.word()) {
      const std::optional<float> number = number_of(word);
      is_sound = is_sound && number.has_value();
      value[count++] = number.value_or(0);
    }
    if (count < 3 || !is_sound)
      faults_.add(lines_.number(), "a vertex has no three numbers; its faces are left out");
    is_sound_.push_back(count >= 3 && is_sound);
    position_.emplace_back(value[0], value[1], value[2]);
    count_all();
    // Scanners write red, green and blue behind the place.
    if (count == 6 && (has_colour_ || position_.size() == 1)) {
      has_colour_ = true;
      colour_.emplace_back(linear_of(value[3]), linear_of(value[4]), linear_of(value[5]), 1);
    } else if (has_colour_) {
      colour_.emplace_back(1);
    }
  }

  void take_texture_place() {
    const float u = number_of(lines_.word()).value_or(0), v = number_of(lines_.word()).value_or(0);
    texture_place_.emplace_back(u, 1 - v);  // from the lower left
    count_all();
  }

  void count_all() const {
    count(file_, std::max(position_.size(), texture_place_.size()), most_vertices, "vertices");
  }

  /// The entry that an index means, from 1, or from the last backwards; empty where there is none.
  static std::optional<std::size_t> entry_of(std::string_view word, std::size_t count) {
    const std::optional<std::int64_t> index = whole_of(word);
    const auto all = static_cast<std::int64_t>(count);
    if (!index || *index == 0 || *index > all || *index < -all) return {};
    return static_cast<std::size_t>(*index > 0 ? *index - 1 : all + *index);
  }

  void take_face() {
    std::vector<std::pair<std::size_t, std::optional<std::size_t>>> corners;
    for (std::string_view word = lines_.word(); !word.empty(); word = lines_.word()) {
      const std::size_t slash = std::min(word.find('/'), word.size());
      const auto vertex = entry_of(word.substr(0, slash), position_.size());
      if (!vertex || !is_sound_[*vertex])
        return faults_.add(lines_.number(),
                           "a face names a vertex that is not there; it is left out");
      const std::string_view behind = slash < word.size() ? word.substr(slash + 1) : "";
      const std::string_view place = behind.substr(0, behind.find('/'));
      corners.emplace_back(*vertex,
                           place.empty() ? std::nullopt : entry_of(place, texture_place_.size()));
      if (corners.size() > most_corners)
        return faults_.add(lines_.number(), "a face has too many corners; it is left out");
    }
    if (corners.size() < 3)
      return faults_.add(lines_.number(), "a face has less than three corners; it is left out");
    triangles_ += corners.size() - 2;
    count(file_, triangles_, most_triangles, "triangles");
    gltf::Primitive& primitive = primitive_now();
    std::vector<std::uint32_t> indices;
    for (const auto& [vertex, place] : corners) indices.push_back(corner_of(vertex, place));
    add_polygon(indices, primitive);
  }

  gltf::Primitive& primitive_now() {
    const auto [known, is_new] = primitive_of_.emplace(material_, primitives_.size());
    if (is_new) {
      primitives_.emplace_back().material = material_;
      made_.emplace_back();
    }
    current_ = known->second;
    return primitives_[current_];
  }

  /// The primitive's vertex for a place in space and one in the picture.
  std::uint32_t corner_of(std::size_t vertex, std::optional<std::size_t> place) {
    gltf::Primitive& primitive = primitives_[current_];
    const std::uint64_t key = std::uint64_t{vertex} << 32U | (place ? *place + 1 : 0);
    const auto [known, is_new] =
        made_[current_].emplace(key, static_cast<std::uint32_t>(primitive.position.size()));
    if (is_new) {
      primitive.position.push_back(position_[vertex]);
      primitive.uv.push_back(place ? texture_place_[*place] : glm::vec2(0));
      if (has_colour_) primitive.colour.push_back(colour_[vertex]);
    }
    return known->second;
  }

  void use_material(std::string_view name) {
    const auto known = material_of_.find(name);
    material_ = known == material_of_.end() ? gltf::none : known->second;
    if (known == material_of_.end())
      faults_.add(lines_.number(), "a material is used that no library has; it is white");
  }

  std::optional<std::string> read_beside(std::string_view name) {
    std::string path(name);
    std::ranges::replace(path, '\\', '/');
    while (path.starts_with("./")) path.erase(0, 2);
    if (!gltf::stays_below(path)) {
      faults_.add(lines_.number(),
                  fmt::format("'{}' is not in the model's own folder", gltf::plain_name(path)));
      return {};
    }
    std::optional<std::string> bytes = beside_ ? beside_(path) : std::nullopt;
    if (!bytes)
      faults_.add(lines_.number(),
                  fmt::format("there is no file '{}' beside the model", gltf::plain_name(path)));
    return bytes;
  }

  void take_library(std::string_view name) {
    const std::optional<std::string> text = read_beside(name);
    if (!text) return;
    Lines lines(*text);
    gltf::Material* material = nullptr;
    while (lines.next()) {
      const std::string_view word = lines.word();
      if (word == "newmtl") {
        if (materials_.size() >= most_materials) return;
        material_of_.emplace(std::string(lines.rest()),
                             static_cast<std::int32_t>(materials_.size()));
        material = &materials_.emplace_back();
        material->name = gltf::plain_name(lines.rest());
      } else if (material != nullptr) {
        take_property(word, lines, *material);
      }
    }
  }

  void take_property(std::string_view word, Lines& lines, gltf::Material& material) {
    if (word == "Kd" && material.image == gltf::none) {
      for (int i = 0; i < 3; ++i)
        material.base[i] = std::clamp(number_of(lines.word()).value_or(1), 0.0F, 1.0F);
    } else if (word == "d") {
      material.base.w = std::clamp(number_of(lines.word()).value_or(1), 0.0F, 1.0F);
      if (material.base.w < 1) material.alpha = gltf::AlphaMode::Blend;
    } else if (word == "map_Kd") {
      take_picture(picture_name(lines), material);
    }
  }

  /// Options (-o 0 0 0) stand before the name, which may have blanks.
  static std::string_view picture_name(Lines& lines) {
    std::string_view name = lines.rest();
    while (name.starts_with('-')) {
      lines.word();
      name = lines.rest();
      while (!name.empty() && number_of(name.substr(0, name.find(' '))).has_value()) {
        lines.word();
        name = lines.rest();
      }
    }
    return name;
  }

  void take_picture(std::string_view name, gltf::Material& material) {
    const auto [known, is_new] =
        image_of_.emplace(std::string(name), static_cast<std::int32_t>(images_.size()));
    if (is_new) {
      images_.emplace_back();
      if (const std::optional<std::string> bytes = read_beside(name)) {
        Result<Pixels> pixels = gltf::decode_texture(*bytes);
        if (pixels)
          images_.back() = std::move(*pixels);
        else
          faults_.add(0, fmt::format("its picture '{}' cannot be shown ({})",
                                     gltf::plain_name(name), pixels.error().what));
      }
    }
    if (images_[gltf::entry(known->second)].rgba.empty()) return;
    material.image = known->second;
    const float opacity = material.base.w;
    material.base = Vec4{1};
    material.base.w = opacity;
  }

  Lines lines_;
  const std::string& file_;
  const gltf::ReadBeside& beside_;
  std::vector<Vec3> position_;
  std::vector<bool> is_sound_;  ///< By vertex.
  std::vector<Vec4> colour_;
  std::vector<glm::vec2> texture_place_;
  bool has_colour_ = false;
  std::size_t triangles_ = 0, current_ = 0;
  std::int32_t material_ = gltf::none;
  std::map<std::int32_t, std::size_t> primitive_of_;
  std::vector<gltf::Primitive> primitives_;
  std::vector<std::unordered_map<std::uint64_t, std::uint32_t>> made_;  ///< By primitive.
  std::map<std::string, std::int32_t, std::less<>> material_of_, image_of_;
  std::vector<gltf::Material> materials_;
  std::vector<Pixels> images_;
  Faults faults_;
};

}  // namespace

gltf::Model parse_obj(std::string_view text, const std::string& file,
                      const gltf::ReadBeside& beside) {
  return ObjReader(text, file, beside).read();
}

}  // namespace docent::import::object
