#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"

namespace docent {

/// The treads of a straight flight of stairs, in the order in which somebody meets them who goes
/// from one stop to the other. Drawn steps and climbing feet both ask here.
///
/// Distances are metres from where one sets out, along the straight line to where one comes out;
/// heights metres above the floor one sets out from. All treads are equally deep. The uppermost is
/// level with the upper floor.
struct Treads {
  double near = 0;    ///< Where the first one begins.
  double length = 0;  ///< Of all treads together.
  double rise = 0;    ///< From floor to floor; below 0 where the flight leads down.
  int count = 0;

  double depth() const noexcept { return length / count; }
  double begin_of(int tread) const noexcept { return near + tread * depth(); }
  double height_of(int tread) const noexcept {
    return rise * (rise > 0 ? tread + 1 : tread) / count;
  }
  /// Of what one stands on there; before and behind the treads that is a floor.
  double height_at(double distance) const noexcept;
};

/// The treads of a flight within an outline. `outline`: not empty. `here`, `there`: different.
Treads treads_within(std::span<const Vec2> outline, Vec2 here, Vec2 there, double rise) noexcept;

/// The treads on the way from stop to stop where the plan has no hole for a flight.
Treads treads_between(Vec2 here, Vec2 there, double rise) noexcept;

/// A convex hole of a plan.
struct Hole {
  std::size_t ring = 0;       ///< Of the plan.
  std::vector<Vec2> outline;  ///< Counter-clockwise.
};

/// The hole that the plan has between two stops, where it is convex: a flight stands in it.
std::optional<Hole> hole_between(const FloorPlan& plan, Vec2 here, Vec2 there);

}  // namespace docent
