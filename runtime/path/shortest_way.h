#pragma once

#include <memory>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/tangent_graph.h"
#include "runtime/path/reflex_corner.h"
#include "runtime/path/wall_grid.h"
#include "runtime/path/way.h"

namespace docent {

/// A tangent graph made ready for queries. Immutable, so any thread may ask. Borrows the graph.
struct ShortestWayMap {
  ShortestWayMap(const FloorPlan& plan, const TangentGraph& tangents);

  const TangentGraph& graph;
  WallGrid walls;                    ///< For the graph's radius.
  std::vector<ReflexCorner> corner;  ///< One per arc of the graph.
};

/// The shortest way of a disc of the map's radius between two points that keep that radius from all
/// walls (the caller has checked): Ok with length and points, or NoRoute. `clearance_min` is left
/// 0 on a straight way and is the radius on one with bends.
Way shortest_way(const ShortestWayMap& map, Vec2 from, Vec2 to);

}  // namespace docent
