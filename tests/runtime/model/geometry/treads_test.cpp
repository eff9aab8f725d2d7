#include "runtime/model/geometry/treads.h"

#include <gtest/gtest.h>

#include "tests/support/halls.h"

namespace docent {
namespace {

constexpr Vec2 west{1, 2}, east{7, 2};

FloorPlan hall_with_a_hole() {
  test::HallMaker hall;
  hall.room({0, 0}, {10, 10}).block({1.5, 1}, {6, 3});
  return hall.plan;
}

TEST(Treads, LieInTheHoleBetweenTheStopsAndEndOnTheFloorBehindIt) {
  const Treads up = treads_between(hall_with_a_hole(), west, east, 3.4);
  EXPECT_EQ(up.count, 20);
  EXPECT_NEAR(up.riser, 0.17, 1e-12);
  EXPECT_NEAR(up.near, 0.5, 1e-12);
  EXPECT_NEAR(up.begin(up.count), 5, 1e-12);
  EXPECT_NEAR(up.height(up.count - 1), 3.4, 1e-12);

  const Treads down = treads_between(hall_with_a_hole(), east, west, -3.4);
  EXPECT_NEAR(down.near, 1, 1e-12);
  EXPECT_NEAR(down.height(0), -0.17, 1e-12);
}

TEST(Treads, FillTheWholeWayWhereNoHoleLiesBetweenTheStops) {
  test::HallMaker hall;
  hall.room({0, 0}, {10, 10});
  const Treads treads = treads_between(hall.plan, west, east, 1);
  EXPECT_EQ(treads.near, 0);
  EXPECT_NEAR(treads.begin(treads.count), 6, 1e-12);
}

TEST(Treads, AreNoHigherThanAStepAndThereIsAlwaysOne) {
  EXPECT_EQ(steps_of(0.01), 1);
  EXPECT_EQ(steps_of(0.17), 1);
  EXPECT_EQ(steps_of(-0.18), 2);
}

}  // namespace
}  // namespace docent
