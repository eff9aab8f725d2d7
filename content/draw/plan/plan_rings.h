#pragma once

#include <cstdint>

#include "runtime/model/geometry/floor_plan.h"

namespace docent::draw {

/// What a ring of a plan is to somebody who looks at it.
enum class RingRole : std::uint8_t {
  Outline,    ///< The wall about a floor.
  Case,       ///< What stands on the floor and can be walked round in a few steps.
  Partition,  ///< A wall, or several that meet, with floor on every side.
  Block,      ///< What floor runs round and nobody sees into: a core, a court, a part of the house.
};

RingRole role_of(const FloorPlan& plan, const Ring& ring);

/// Has the plan a ring of that role?
bool has_role(const FloorPlan& plan, RingRole role);

}  // namespace docent::draw
