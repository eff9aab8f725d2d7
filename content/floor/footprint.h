#pragma once

#include <array>
#include <span>

#include "runtime/model/geometry/floor_plan.h"

namespace docent::floor {

/// The part of a floor that something takes which stands on it: a rectangle. Floor frame.
struct Footprint {
  Vec2 centre{};
  double heading = 0;  ///< Radians, counter-clockwise from east: where its front looks.
  Vec2 size{};         ///< Metres: across its front, and deep. Both positive.
};

/// Smaller things take no floor: metres, either way.
inline constexpr double smallest_footprint = 0.01;

/// Its corners, counter-clockwise.
std::array<Vec2, 4> corners_of(const Footprint& footprint);

bool covers(const Footprint& footprint, Vec2 point);

/// Metres from a point outside to the footprint; 0 inside.
double distance_to(const Footprint& footprint, Vec2 point);

/// Metres from its middle to its edge in a direction of length 1.
double distance_to_edge(const Footprint& footprint, Vec2 direction);

/// By how many metres one of two footprints would have to be moved so that they are apart; 0 where
/// they are.
double overlap_of(const Footprint& a, const Footprint& b);

/// The plan with footprints as obstacles: what they cover is no floor. Footprints that reach into
/// walls or each other become one with them. `plan` keeps the invariants of FloorPlan, and so does
/// the answer, which has its name, height and doors. Throws ContentError where nothing walkable
/// remains.
FloorPlan with_obstacles(const FloorPlan& plan, std::span<const Footprint> footprints);

}  // namespace docent::floor
