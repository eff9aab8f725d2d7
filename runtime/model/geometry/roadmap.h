#pragma once

#include <cstdint>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// One piece of the medial axis between two nodes: a Voronoi edge.
struct RoadmapEdge {
  std::uint32_t from = 0, to = 0;  ///< Nodes.
  std::uint32_t voronoi_edge =
      0;                 ///< Gives the shape: a line or a parabolic arc, run in the same direction.
  double length = 0;     ///< Metres along the arc.
  double clearance = 0;  ///< Metres, the smallest along it. Positive.
};

/// Where an avatar can walk in the middle of the room: the medial axis of one floor with its
/// clearance.
///
/// Frame: floor. Every edge joins two nodes; an edge's clearance is at most that of either end.
/// Immutable once loaded. Node i is Voronoi vertex voronoi_vertex[i].
struct Roadmap {
  std::vector<Vec2> position;
  std::vector<double> clearance;  ///< Metres.
  std::vector<std::uint32_t> voronoi_vertex;
  std::vector<RoadmapEdge> edges;
};

}  // namespace docent
