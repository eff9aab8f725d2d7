#pragma once

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/sight_map.h"

namespace docent::floor {

/// What every reflex corner of a mended plan sees: triangular expansion (Bungiu, Hemmer,
/// Hershberger, Huang, Kroeller 2014) over the constrained Delaunay triangulation of the interior,
/// with exact predicates. Corners that are seen only along a line of no width, between two others
/// that touch it from both sides, are left out: whoever goes along that line passes those two.
/// Cost: as much as is seen, and the triangulation.
SightMap make_sight_map(const FloorPlan& plan);

}  // namespace docent::floor
