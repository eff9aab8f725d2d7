#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"

namespace docent::floor {

/// What keeps a door from being closed.
struct DoorFault {
  enum class Kind : std::uint8_t {
    Outside,    ///< Its middle is not where one can walk: it is left as it is.
    LeavesGap,  ///< One of its ends is far from every wall: one can go round it.
  };
  std::uint32_t door = 0;  ///< Index into the doors.
  Kind kind = Kind::Outside;
  double gap = 0;  ///< Metres, from the end to the wall that it would reach.
  Vec2 end{};
};

/// How thick a closed door is, metres.
inline constexpr double door_thickness = 0.02;

/// The plan with its closed doors as walls. `plan` keeps the invariants of FloorPlan, and so does
/// the answer. Open doors are left out of account; what is wrong with closed ones is appended to
/// `faults`.
FloorPlan close_doors(const FloorPlan& plan, std::span<const Door> doors,
                      std::vector<DoorFault>& faults);

}  // namespace docent::floor
