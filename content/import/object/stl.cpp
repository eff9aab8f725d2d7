#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "content/import/object/kinds.h"
#include "content/import/object/object_text.h"
#include "content/import/object/one_primitive.h"

namespace docent::import::object {
namespace {

constexpr std::size_t header_size = 84, triangle_size = 50;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (unsigned i = 0; i < 4; ++i)
    word |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i);
  return word;
}

/// Many exporters begin binary files with "solid", too: what is binary is as long as it says.
bool is_binary(std::string_view bytes) {
  if (bytes.size() < header_size) return false;
  const std::size_t count = word_at(bytes, 80);
  if (bytes.size() == header_size + count * triangle_size) return true;
  return !bytes.starts_with("solid") || bytes.substr(0, header_size).contains('\0');
}

/// Joins corners that lie on one place, which is all that an STL file says of its surface.
class Welder {
 public:
  explicit Welder(const std::string& file) : file_{file} {}

  void add(const std::array<Vec3, 3>& triangle, std::uint32_t line) {
    std::vector<std::uint32_t> corners;
    for (const Vec3& p : triangle) {
      constexpr float farthest = 1e6F;
      if (!(std::abs(p.x) <= farthest && std::abs(p.y) <= farthest && std::abs(p.z) <= farthest))
        return faults.add(line, "a triangle has a corner that is nowhere; it is left out");
      corners.push_back(corner_at(p));
    }
    add_polygon(corners, primitive);
    count(file_, primitive.indices.size() / 3, most_triangles, "triangles");
  }

  gltf::Primitive primitive;
  Faults faults;

 private:
  struct Hash {
    std::size_t operator()(const std::array<std::uint32_t, 3>& bits) const noexcept {
      std::uint64_t hash = 0;
      for (const std::uint32_t word : bits) hash = (hash ^ word) * 0x9E3779B97F4A7C15U;
      return hash ^ hash >> 32U;
    }
  };

  std::uint32_t corner_at(Vec3 p) {
    p += Vec3{0.0F};  // -0 is 0
    const auto [known, is_new] = known_.emplace(
        std::array{std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                   std::bit_cast<std::uint32_t>(p.z)},
        static_cast<std::uint32_t>(primitive.position.size()));
    if (is_new) primitive.position.push_back(p);
    return known->second;
  }

  const std::string& file_;
  std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, Hash> known_;
};

void read_binary(std::string_view bytes, const std::string& file, Welder& welder) {
  const std::size_t stated = word_at(bytes, 80);
  const std::size_t there = (bytes.size() - header_size) / triangle_size;
  if (there == 0) fail(file, 0, "it ends before its first triangle");
  if (stated != there)
    welder.faults.add(
        0, fmt::format("it says that there are {} triangles, and holds {}", stated, there));
  const std::size_t used = stated == 0 ? there : std::min(stated, there);
  count(file, used, most_triangles, "triangles");
  for (std::size_t i = 0; i < used; ++i) {
    std::array<Vec3, 3> triangle;
    for (std::size_t k = 0; k < 9; ++k)
      triangle[k / 3][static_cast<int>(k % 3)] =
          std::bit_cast<float>(word_at(bytes, header_size + i * triangle_size + 12 + 4 * k));
    welder.add(triangle, 0);
  }
}

void read_text(std::string_view text, Welder& welder) {
  Lines lines(text);
  std::array<Vec3, 3> triangle{};
  std::size_t corners = 0;
  bool is_sound = true;
  while (lines.next()) {
    const std::string_view word = lines.word();
    if (word == "facet" || word == "outer") {
      corners = 0;
      is_sound = true;
    } else if (word == "vertex") {
      for (int axis = 0; axis < 3; ++axis) {
        const std::optional<float> number = number_of(lines.word());
        is_sound = is_sound && number && corners < 3;
        if (is_sound) triangle[corners][axis] = *number;
      }
      ++corners;
    } else if (word == "endloop" && (corners != 3 || !is_sound)) {
      welder.faults.add(lines.number(),
                        "a triangle has no three corners of three numbers; it is left out");
    } else if (word == "endloop") {
      welder.add(triangle, lines.number());
      corners = 0;
    }
  }
}

}  // namespace

bool is_stl(std::string_view bytes) {
  if (bytes.starts_with("solid") && bytes.contains("facet")) return true;
  // A binary file has no mark of its own but its length.
  return bytes.size() >= header_size &&
         bytes.size() == header_size + word_at(bytes, 80) * triangle_size;
}

gltf::Model parse_stl(std::string_view bytes, const std::string& file) {
  Welder welder(file);
  if (is_binary(bytes))
    read_binary(bytes, file, welder);
  else
    read_text(bytes, welder);
  gltf::Model model = scene_of({std::move(welder.primitive)});
  model.warnings = welder.faults.told();
  return model;
}

}  // namespace docent::import::object
