#pragma once

#include <cstdint>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// What a Voronoi region belongs to: the open side of a wall, or a reflex corner (one that juts
/// into the floor).
struct Site {
  enum class Kind : std::uint8_t { Wall, Corner };
  Kind kind = Kind::Wall;
  std::uint32_t index = 0;  ///< Of the wall, or of the vertex, in the FloorPlan.
};

/// A piece of a bisector: points equally far from two sites, and nearer to no other.
///
/// Wall and wall, or corner and corner: a line. Wall and corner: an arc of the parabola with the
/// corner as its focus and the wall's line as its directrix; it degenerates to a line where the
/// corner is an end of the wall.
struct VoronoiEdge {
  std::uint32_t from = 0, to = 0;     ///< Voronoi vertices.
  std::uint32_t left = 0, right = 0;  ///< Sites, as seen when going from `from` to `to`.
  bool on_medial_axis = false;  ///< Separates two different walls, not a wall from its own corner.
  bool parabola = false;
};

/// The segment Voronoi diagram of a floor's walls, restricted to the walkable interior.
///
/// Frame: floor. `vertex` and `clearance` have one entry per Voronoi vertex; clearance is the
/// distance to the nearest wall, 0 at the corners of the plan where the diagram ends. The edges
/// round region s, counter-clockwise as seen from inside it, are region_edge[region_first[s] ..
/// region_first[s + 1]); the wall itself closes the loop. region_first has site.size() + 1 entries.
struct VoronoiDiagram {
  std::vector<Site> site;
  std::vector<Vec2> vertex;
  std::vector<double> clearance;
  std::vector<VoronoiEdge> edge;
  std::vector<std::uint32_t> region_first;
  std::vector<std::uint32_t> region_edge;
};

}  // namespace docent
