#pragma once

#include <cstddef>
#include <span>

#include "runtime/model/geometry/vec2.h"

/// Polygons as lists of their corners, the first not repeated at the end.
namespace docent {

/// Square metres; negative for a clockwise one.
inline double signed_area(std::span<const Vec2> polygon) noexcept {
  if (polygon.empty()) return 0;
  double doubled = 0;
  const Vec2 origin = polygon.front();  // Keeps the digits of plans that are far from (0, 0).
  for (std::size_t i = 0; i < polygon.size(); ++i)
    doubled += cross(polygon[i] - origin, polygon[(i + 1) % polygon.size()] - origin);
  return doubled / 2;
}

/// Is the point inside, counting crossings of the ray to the east?
inline bool contains(std::span<const Vec2> polygon, Vec2 p) noexcept {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i];
    const Vec2 b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
      inside = !inside;
  }
  return inside;
}

}  // namespace docent
