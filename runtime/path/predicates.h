#pragma once

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// The sign of the turn a -> b -> c: +1 left, -1 right, 0 exactly straight. Exact for all doubles
/// whose products neither overflow nor underflow (Shewchuk 1997, "Adaptive precision
/// floating-point arithmetic and fast robust geometric predicates").
int orientation(Vec2 a, Vec2 b, Vec2 c) noexcept;

/// Distance from `p` to the segment a b, squared, and the place on it.
struct NearestOnSegment {
  double distance_squared = 0;
  double t = 0;  ///< In [0, 1]: 0 at a, 1 at b.
};
NearestOnSegment nearest_on_segment(Vec2 p, Vec2 a, Vec2 b) noexcept;

/// Distance between the segments p q and a b, squared; 0 where they cross.
double segment_distance_squared(Vec2 p, Vec2 q, Vec2 a, Vec2 b) noexcept;

}  // namespace docent
