#pragma once

#include <cstddef>

#include "runtime/model/geometry/floor_plan.h"

namespace docent::bench {

/// Boost.Polygon's segment Voronoi diagram (a sweep line on integers, here of 0.1 mm) of a plan's
/// walls, on both sides of them; returns how many vertices it has. Here to be compared with.
std::size_t make_boost_diagram(const FloorPlan& plan);

}  // namespace docent::bench
