#pragma once

#include <vector>

#include "content/scenery/mesh_builder.h"
#include "runtime/model/geometry/floor_plan.h"

namespace docent::scenery {

/// Adds a lift's car to a plan that is only drawn: an alcove behind the wall that one at `stop`
/// looks at, its doorway in the wall. Nothing where there is no straight wall within a step, or
/// where something else lies behind it. Gives the leaves of its door, half open; none where nothing
/// was added. Vertices and rings keep their order.
std::vector<Outline> add_lift_car(const Placement& stop, FloorPlan& plan);

/// Builds the leaves of a lift's door.
void build_lift_door(const std::vector<Outline>& leaves, MeshBuilder& mesh);

}  // namespace docent::scenery
