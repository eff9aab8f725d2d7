#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>

#include "content/object/shape.h"

/// What a closed surface encloses.
namespace docent::test {

inline Vec3 corner(const object::Shape& shape, std::size_t k) {
  return shape.vertices[shape.indices[k]].position;
}

/// Every edge is walked once each way.
inline bool is_closed(const object::Shape& shape) {
  std::map<std::array<float, 6>, int> edges;
  for (std::size_t k = 0; k < shape.indices.size(); ++k) {
    const Vec3 a = corner(shape, k), b = corner(shape, k % 3 == 2 ? k - 2 : k + 1);
    if (a == b) return false;
    ++edges[{a.x, a.y, a.z, b.x, b.y, b.z}];
    --edges[{b.x, b.y, b.z, a.x, a.y, a.z}];
  }
  return std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; });
}

/// Positive where the surface looks outwards.
inline double volume_of(const object::Shape& shape) {
  double volume = 0;
  for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3) {
    const glm::dvec3 a(corner(shape, k)), b(corner(shape, k + 1)), c(corner(shape, k + 2));
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return volume;
}

}  // namespace docent::test
