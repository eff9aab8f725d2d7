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

/// Distance between the segments p q and a b, squared; 0 where they cross.
inline double segment_distance_squared(Vec2 p, Vec2 q, Vec2 a, Vec2 b) noexcept {
  const Vec2 pq = q - p, ab = b - a;
  const double a_side = cross(pq, a - p), b_side = cross(pq, b - p);
  const double p_side = cross(ab, p - a), q_side = cross(ab, q - a);
  if (((a_side < 0) != (b_side < 0)) && ((p_side < 0) != (q_side < 0))) return 0;
  return std::min(
      {nearest_on_segment(p, a, b).distance_squared, nearest_on_segment(q, a, b).distance_squared,
       nearest_on_segment(a, p, q).distance_squared, nearest_on_segment(b, p, q).distance_squared});
}

}  // namespace docent
