#pragma once

#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/sight_map.h"
#include "runtime/model/geometry/tangent_graph.h"
#include "runtime/path/index/wall_grid.h"
#include "runtime/path/shortest/reflex_corner.h"

namespace docent::path {

/// Radii below this count as 0. Metres.
inline constexpr double smallest_radius = 1e-7;

/// The tangent graph of a floor for discs of one radius, as touching.h says what fits. Takes time
/// in proportion to how many corners see each other. The content compiler stores those of the
/// museum's radius classes; the runtime makes any other one itself. A radius that is negative or
/// not finite gives a graph without tangents.
TangentGraph make_tangent_graph(const FloorPlan& plan, const SightMap& sight, double radius);

/// The corners that the arcs of a graph belong to, one per arc.
std::vector<ReflexCorner> corners_of_arcs(const FloorPlan& plan, const TangentGraph& graph);

}  // namespace docent::path
