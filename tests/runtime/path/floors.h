#pragma once

#include <initializer_list>
#include <optional>

#include "runtime/model/geometry/floor.h"
#include "runtime/path/route.h"
#include "tests/content/floor/plans.h"
#include "tests/content/floor/random_plan.h"
#include "tests/runtime/path/oracles.h"

namespace docent::test {

/// A floor as the content compiler makes it, with tangent graphs for the given radii.
Floor floor_of(const FloorPlan& plan, std::initializer_list<double> radii = {0});
inline Floor floor_of(const import::ImportedPlan& plan, std::initializer_list<double> radii = {0}) {
  return floor_of(mended(plan), radii);
}

/// A hall of 12 by 8 m with one box standing in the middle, from (5, 3) to (7, 5).
import::ImportedPlan hall_with_a_box();
/// Two rooms of 4 by 4 m side by side, joined by a door of the given width in a wall 0.2 m thick.
import::ImportedPlan two_rooms(double door_width);

/// A random hall with at most eight obstacles, none of which touch in a point: there the mended
/// plan lets nobody through, which is not what the oracles here know. None where it has no floor.
std::optional<FloorPlan> random_hall();
/// A random point of the hall, to the centimetre.
Vec2 random_point();

}  // namespace docent::test
