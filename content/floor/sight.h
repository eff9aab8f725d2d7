#pragma once

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/sight_map.h"
#include "runtime/model/geometry/voronoi_diagram.h"

namespace docent::floor {

/// What every reflex corner of a mended plan sees: triangular expansion (Bungiu, Hemmer,
/// Hershberger, Huang, Kroeller 2014) over the constrained Delaunay triangulation of the interior,
/// with exact predicates. Corners that are seen only along a line of no width, between two others
/// that touch it from both sides, are left out: whoever goes along that line passes those two; so
/// are pairs between which no disc that the floor has room for would go straight (bend.h). Cost: as
/// much as is seen, and the triangulation.
///
/// Throws ContentError where points may go straight between corners along more lines than a
/// database holds, before anything slow is begun.
SightMap make_sight_map(const FloorPlan& plan, const VoronoiDiagram& diagram);

}  // namespace docent::floor
