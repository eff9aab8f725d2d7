#pragma once

#include <span>

#include "content/import/floor/imported_plan.h"
#include "runtime/model/geometry/floor_plan.h"

namespace docent::floor {

/// The thickest wall that a door opens, metres.
inline constexpr double thickest_opened = 0.8;

/// Opens the walls in which doors stand: where a door's middle is in a wall, with floor on both
/// sides of it no farther apart than walls are thick, the plan gets the doorway as one more area. A
/// plan without doors (rooms as closed outlines, say) needs one line for each. Doors on the floor,
/// and those with a wall and nothing behind it, change nothing.
void open_doors(import::ImportedPlan& plan, std::span<const Door> doors);

}  // namespace docent::floor
