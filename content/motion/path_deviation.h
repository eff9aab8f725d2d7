#pragma once

#include <span>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::motion::offline {

/// How closely a body kept to a path. Metres.
struct PathDeviation {
  double mean = 0, largest = 0;
  double reached = 0;  ///< Along the path.
};

/// The offset of each root position from the nearest point of the path, searched forward along it,
/// averaged as a vector over one second: the sway of the gait cancels out, a cut corner does not.
/// `path` has at least two points.
PathDeviation measure_deviation(std::span<const Vec2> roots, double frame_rate,
                                std::span<const Vec2> path);

}  // namespace docent::motion::offline
