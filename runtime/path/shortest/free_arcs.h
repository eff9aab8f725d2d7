#pragma once

#include <cstdint>
#include <vector>

#include "runtime/path/index/wall_grid.h"
#include "runtime/path/shortest/reflex_corner.h"

namespace docent::path {

/// A part of a corner's circle, in the corner's own angles.
struct ArcInterval {
  double begin = 0, end = 0;
};

/// The parts of a corner's circle on which a disc of `radius` rolls that keep the least clearance
/// from every wall, ascending. `before` is the wall that ends at the corner; `walls` a grid of any
/// radius.
std::vector<ArcInterval> free_arcs(const FloorPlan& plan, const WallGrid& walls,
                                   const ReflexCorner& corner, std::uint32_t before, double radius);

/// Takes out of parts of the circle of radius `rolling` about a corner what is nearer than `reach`
/// to the segment a b.
void cut_arcs(const ReflexCorner& corner, double rolling, double reach, Vec2 a, Vec2 b,
              std::vector<ArcInterval>& free);

}  // namespace docent::path
