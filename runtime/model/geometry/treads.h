#pragma once

#include <cstddef>
#include <optional>

#include "runtime/model/geometry/floor_plan.h"

namespace docent {

/// The steps of a straight flight as one comes to it, by distances along the way from the stop
/// before it to the stop behind it. The last tread is level with the floor behind.
struct Treads {
  double near = 0;   ///< Metres from the stop to the first riser.
  double depth = 0;  ///< Metres of one tread.
  int count = 0;     ///< At least one.
  double riser = 0;  ///< Metres from one tread up to the next; below 0: the flight leads down.

  double begin(int tread) const noexcept { return near + tread * depth; }
  double height(int tread) const noexcept { return (tread + 1) * riser; }
  double rise() const noexcept { return count * riser; }
};

/// How many steps a flight of that rise has, metres, of either sign.
int steps_of(double rise) noexcept;

/// The ring of the convex hole that lies between two stops: what a flight is built in. None where
/// one can walk between them: nothing may be built there.
std::optional<std::size_t> flight_hole(const FloorPlan& plan, Vec2 here, Vec2 there);

/// The treads between two stops that lie apart, in the hole between them or, without one, all the
/// way. `rise`: of the floor there above the floor here, not 0.
Treads treads_between(const FloorPlan& plan, Vec2 here, Vec2 there, double rise);

}  // namespace docent
