#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "content/scenery/scenery.h"

namespace docent::scenery {

/// What a piece of the plan's plane is.
enum class PlateKind : std::uint8_t {
  Outside,  ///< Beyond the building's walls.
  Wall,     ///< Solid, cut at shoulder height.
  Floor,    ///< Where one can walk.
  Hole,     ///< Something that stands in the room: a case, a column.
};

/// A triangle of the plane, counter-clockwise in the floor frame. `area` is 1 + the index of the
/// paved area that a Floor or Hole lies in; 0: none.
struct Plate {
  std::array<Vec2, 3> corner{};
  PlateKind region = PlateKind::Outside;
  std::uint32_t area = 0;
};

/// Where a Wall ends: seen from the open side, the wall is behind the edge and `a` is on the left.
struct WallEdge {
  Vec2 a{}, b{};
};

struct Plates {
  std::vector<Plate> plates;  ///< Outside is left out.
  std::vector<WallEdge> wall_edges;
};

/// Divides the plane into floor, walls and holes. Rings marked in `furniture` (one flag per ring)
/// become Holes whole; behind every other ring stands a wall `thickness` metres thick, and what
/// lies further behind is Outside. Wall edges are cut into pieces that grow from the corners, for
/// the light that is kept at their ends; plates and edges share their corners exactly.
Plates divide(const FloorPlan& plan, const std::vector<bool>& furniture, double thickness,
              std::span<const PavedArea> paving);

}  // namespace docent::scenery
