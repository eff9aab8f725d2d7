#pragma once

#include "runtime/model/geometry/floor_plan.h"

namespace docent {

/// A closed door: the segment from wall to wall in which nobody passes. Where an end of the door is
/// drawn no farther from a wall than `largest_door_gap`, along the door, the leaf reaches that
/// wall.
struct DoorLeaf {
  /// An end, and how far it is from the wall that it would have to reach; 0 where it is at one.
  struct End {
    Vec2 at{};
    double gap = 0;
  };
  End a, b;
};

/// Metres.
inline constexpr double largest_door_gap = 0.3;

/// Is the point in the walkable interior? In time linear in the plan.
bool is_walkable(const FloorPlan& plan, Vec2 point) noexcept;

/// Is any part of the door in the walkable interior? What stands in a wide doorway may leave a part
/// on either side of it, and not its middle.
bool crosses_floor(const FloorPlan& plan, const Door& door);

/// The leaf of a door that crosses the floor.
DoorLeaf door_leaf(const FloorPlan& plan, const Door& door) noexcept;

}  // namespace docent
