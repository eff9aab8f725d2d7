#pragma once

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/voronoi_diagram.h"

namespace docent::floor {

/// The segment Voronoi diagram of a plan's walls inside the walkable floor.
///
/// Its combinatorics come from CGAL's segment Delaunay graph (Karavelas 2004) with exact
/// predicates; its vertices are computed anew from their three sites in long double, so each is
/// equally far from all of its sites to within 1e-9 m. Vertices that coincide are merged.
///
/// Sites: every wall, in the plan's order (site i is wall i), then every reflex corner in the order
/// of the vertices. Edges and vertices are in an order that depends on the plan alone.
/// Needs a plan that keeps FloorPlan's invariants (see mend.h); throws ContentError otherwise.
VoronoiDiagram voronoi_diagram(const FloorPlan& plan);

}  // namespace docent::floor
