#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "content/scenery/furniture.h"
#include "content/scenery/mesh_builder.h"
#include "content/scenery/passage.h"
#include "runtime/model/geometry/floor_plan.h"

namespace docent::scenery {

/// A straight flight of stairs, an escalator or a ramp, within its hole of the plan.
struct Flight {
  Passage passage;
  std::size_t ring = 0;  ///< Of the plan: the hole.
  Outline footprint;     ///< Convex.
};

/// The flight that a passage is, where the plan has a convex hole between its stops; nothing for a
/// lift, or where one can walk between them: nothing may be built there.
std::optional<Flight> flight_of(const FloorPlan& plan, const Passage& passage);

/// Builds a flight. One that leads up is solid, and cut at the height of the walls; one that leads
/// down is an opening in the floor with all of its steps in it and a rail round it. What raises or
/// sinks the floor is added to `blockers`.
void build_flight(const Flight& flight, MeshBuilder& mesh, std::vector<Blocker>& blockers);

}  // namespace docent::scenery
