#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"

namespace docent::bench {

/// Do the walls run along the axes, or at an odd angle to them? The first makes many ties, the
/// second none.
enum class Turn : std::uint8_t { Straight, Slanting };

/// A museum of halls of 12 m by 12 m with doors in all walls between them and four cases or columns
/// in each, with about so many walls (34 a hall). The same plan every time. On a grid of 0.1 mm.
FloorPlan generated_museum(std::size_t walls, Turn turn);

/// A floor that is one corridor, without holes, and the places where it turns, from end to end.
struct Corridor {
  FloorPlan plan;
  std::vector<Vec2> turns;
};
/// Up and down: a shortest path bends left and right in turn, at every turn.
Corridor zigzag_corridor(std::size_t turns);
/// Round and round, outwards, 2 m wide: it always bends left.
Corridor spiral_corridor(std::size_t turns);

}  // namespace docent::bench
