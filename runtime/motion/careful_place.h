#pragma once

#include "runtime/model/geometry/vec2.h"

namespace docent::motion {

/// Where a walker takes care: within `radius` metres of the place it walks at most at `share` of
/// the ordinary speed, by shorter strides; it slows down before that. Floor frame.
struct CarefulPlace {
  Vec2 at{};
  double radius = 1;
  double share = 1;
};

}  // namespace docent::motion
