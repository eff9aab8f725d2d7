#pragma once

#include <algorithm>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// The place of a segment a b that is nearest to a point, and its distance, squared.
struct NearestOnSegment {
  double distance_squared = 0;
  double t = 0;  ///< In [0, 1]: 0 at a, 1 at b. 0 for a segment without length.
};
inline NearestOnSegment nearest_on_segment(Vec2 p, Vec2 a, Vec2 b) noexcept {
  const Vec2 along = b - a;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  const Vec2 apart = t == 1 ? p - b : p - a - t * along;
  return {dot(apart, apart), t};
}
inline double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) noexcept {
  return std::sqrt(nearest_on_segment(p, a, b).distance_squared);
}

}  // namespace docent
