#include "content/object/agree.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <meshoptimizer.h>

namespace docent::object {
namespace {

constexpr std::uint32_t nobody = 0xFFFFFFFFU;

/// Across each side of a triangle: who is there, and do both run along the side the same way, so
/// that one of them faces the other way?
struct Across {
  std::array<std::uint32_t, 3> triangle{nobody, nobody, nobody};
  std::array<bool, 3> disagrees{};
};

/// Sides that more than two triangles share join nobody.
std::vector<Across> neighbours(const Shape& shape) {
  std::vector<Vec3> place;
  for (const ShapeVertex& v : shape.vertices) place.push_back(v.position);
  std::vector<std::uint32_t> number(place.size());
  meshopt_generateVertexRemap(number.data(), shape.indices.data(), shape.indices.size(),
                              place.data(), place.size(), sizeof(Vec3));
  struct Side {
    std::uint32_t low, high, corner;
    bool rises;
    bool is_of(const Side& other) const { return low == other.low && high == other.high; }
  };
  std::vector<Side> sides;
  sides.reserve(shape.indices.size());
  for (std::uint32_t k = 0; k < shape.indices.size(); ++k) {
    const std::uint32_t next = k % 3 == 2 ? k - 2 : k + 1;
    const std::uint32_t a = number[shape.indices[k]], b = number[shape.indices[next]];
    if (a != b) sides.push_back({std::min(a, b), std::max(a, b), k, a < b});
  }
  std::ranges::sort(sides, {}, [](const Side& s) { return std::array{s.low, s.high, s.corner}; });
  std::vector<Across> all(shape.indices.size() / 3);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].is_of(sides[i])) ++end;
    if (end == i + 2)
      for (const auto& [one, other] :
           {std::pair(sides[i], sides[i + 1]), std::pair(sides[i + 1], sides[i])}) {
        all[one.corner / 3].triangle[one.corner % 3] = other.corner / 3;
        all[one.corner / 3].disagrees[one.corner % 3] = one.rises == other.rises;
      }
    i = end;
  }
  return all;
}

Vec3 corner_of(const Shape& shape, std::uint32_t triangle, std::size_t corner) {
  return shape.vertices[shape.indices[3 * std::size_t{triangle} + corner]].position;
}

/// Six times the room that a surface holds, seen from its middle; negative where it faces inwards.
double room_of(const Shape& shape, const std::vector<std::uint32_t>& surface,
               const std::vector<bool>& is_turned) {
  Vec3 middle{0};
  for (const std::uint32_t triangle : surface) middle += corner_of(shape, triangle, 0);
  middle /= static_cast<float>(surface.size());
  double room = 0;
  for (const std::uint32_t triangle : surface) {
    const Vec3 a = corner_of(shape, triangle, 0) - middle,
               b = corner_of(shape, triangle, 1) - middle,
               c = corner_of(shape, triangle, 2) - middle;
    const double own = glm::dot(a, glm::cross(b, c));
    room += is_turned[triangle] ? -own : own;
  }
  return room;
}

}  // namespace

std::size_t agree(Shape& shape) {
  const std::vector<Across> across = neighbours(shape);
  std::vector<bool> is_known(across.size()), is_turned(across.size());
  std::vector<std::uint32_t> surface;
  for (std::uint32_t first = 0; first < across.size(); ++first) {
    if (is_known[first]) continue;
    bool agrees = true;
    surface.assign(1, first);
    is_known[first] = true;
    for (std::size_t i = 0; i < surface.size(); ++i)  // it grows
      for (std::size_t side = 0; side < 3; ++side) {
        const std::uint32_t other = across[surface[i]].triangle[side];
        if (other == nobody || is_known[other]) continue;
        const bool disagrees = across[surface[i]].disagrees[side];
        agrees = agrees && !disagrees;
        is_known[other] = true;
        is_turned[other] = is_turned[surface[i]] != disagrees;
        surface.push_back(other);
      }
    if (!agrees && room_of(shape, surface, is_turned) < 0)
      for (const std::uint32_t triangle : surface) is_turned[triangle] = !is_turned[triangle];
  }
  std::size_t turned = 0;
  for (std::size_t triangle = 0; triangle < across.size(); ++triangle) {
    if (!is_turned[triangle]) continue;
    std::swap(shape.indices[3 * triangle + 1], shape.indices[3 * triangle + 2]);
    ++turned;
  }
  return turned;
}

}  // namespace docent::object
