#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/none.h"

namespace docent::floor {

/// Three sites that a disc touches which holds no part of any other: a Voronoi vertex.
///
/// Site i is wall i; site plan.vertex.size() + i is the corner at vertex i. Where several corners
/// lie in one place, the reflex one stands for all of them, or else the last. `none` is a point
/// behind walls that is there to keep their backs apart, and no site of the plan.
struct SiteTriangle {
  std::array<std::uint32_t, 3> site{};  ///< Counter-clockwise.
  std::array<std::uint32_t, 3>
      neighbour{};  ///< Beyond the side opposite site i; `none` at the rim.
};

/// The segment Delaunay graph of all walls and corners of a plan: the dual of the Voronoi diagram
/// of the whole plane, in which a wall has two sides. Where more than three sites meet in one
/// vertex, there is a triangle for each three of them that any triangulation would take.
struct SiteGraph {
  std::vector<SiteTriangle> triangle;
  /// Vertices at which the plan does not turn left, so that the floor goes round them. A corner
  /// that is straight on (another wall's corner touches there) counts, too: its region is a line.
  std::vector<std::uint32_t> reflex_corner;
};

/// Computes the graph with exact predicates (Karavelas 2004, as implemented in CGAL), so it is the
/// right one whatever the doubles are. Throws ContentError where walls cross or overlap.
SiteGraph site_graph(const FloorPlan& plan);

}  // namespace docent::floor
