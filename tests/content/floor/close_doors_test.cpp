#include "content/floor/close_doors.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "runtime/model/geometry/polygon.h"
#include "tests/content/floor/random_plan.h"

namespace docent::floor::close_doors_test {
namespace {

using test::drawn;
using test::mended;
using test::rectangle;

/// Two rooms of 4 by 4 m, joined by a door of 1 m in a wall 0.2 m thick.
FloorPlan two_rooms() {
  import::ImportedPlan plan = drawn(rectangle({0, 0}, {4, 4}));
  plan.polygons.push_back(drawn(rectangle({4.2, 0}, {8.2, 4})).polygons.front());
  plan.polygons.push_back(drawn(rectangle({4, 1.5}, {4.2, 2.5})).polygons.front());
  return mended(plan);
}

double area_of(const FloorPlan& plan) {
  double area = 0;
  for (const Ring& ring : plan.ring)
    area += signed_area(
        {plan.vertex.begin() + ring.first, plan.vertex.begin() + ring.first + ring.count});
  return area;
}

Door door(Vec2 a, Vec2 b, bool closed = true) {
  return {.name = "door", .a = a, .b = b, .closed = closed};
}

struct Closed {
  FloorPlan plan;
  std::vector<DoorFault> faults;
};
Closed closed(const FloorPlan& plan, const std::vector<Door>& doors) {
  Closed result;
  result.plan = close_doors(plan, doors, result.faults);
  return result;
}

TEST(AClosedDoor, PartsTwoRooms) {
  const Closed result = closed(two_rooms(), {door({4.1, 1.5}, {4.1, 2.5})});

  EXPECT_TRUE(result.faults.empty());
  EXPECT_EQ(result.plan.ring.size(), 2U);
  EXPECT_NEAR(area_of(result.plan), 16 + 16 + 0.2 - door_thickness, 1e-9);
}

TEST(AClosedDoor, PartsThemWhereItsEndsFallShortOfTheFrameOrReachIntoTheWall) {
  for (const auto& [a, b] :
       {std::pair{Vec2{4.1, 1.6}, Vec2{4.1, 2.3}}, std::pair{Vec2{4.1, 1.2}, Vec2{4.1, 2.9}},
        std::pair{Vec2{4.05, 1.55}, Vec2{4.15, 2.45}}})
    EXPECT_EQ(closed(two_rooms(), {door(a, b)}).plan.ring.size(), 2U);
}

TEST(AnOpenDoor, ChangesNothing) {
  const FloorPlan plan = two_rooms();

  EXPECT_EQ(closed(plan, {door({4.1, 1.5}, {4.1, 2.5}, false)}).plan.vertex, plan.vertex);
}

TEST(AClosedDoor, OutsideTheFloorIsAFault) {
  const Closed result = closed(two_rooms(), {door({4.1, 3}, {4.1, 3.5})});

  ASSERT_EQ(result.faults.size(), 1U);
  EXPECT_EQ(result.faults[0].kind, DoorFault::Kind::Outside);
  EXPECT_EQ(result.plan.ring.size(), 1U);
}

TEST(AClosedDoor, InTheMiddleOfARoomIsAFaultAtBothEnds) {
  const Closed result = closed(two_rooms(), {door({2, 1}, {2, 2})});

  ASSERT_EQ(result.faults.size(), 2U);
  EXPECT_EQ(result.faults[0].kind, DoorFault::Kind::LeavesGap);
  EXPECT_DOUBLE_EQ(result.faults[0].gap, 1);
  EXPECT_DOUBLE_EQ(result.faults[1].gap, 2);
}

/// A slanted wall across a hall with a gap anywhere in it is a wall once its door is closed.
RC_GTEST_PROP(AClosedDoor, PartsAHallWhereverItIs, ()) {
  const double low = 0.01 * *rc::gen::inRange(100, 1000),
               high = 0.01 * *rc::gen::inRange(100, 1000);
  const double from = 0.01 * *rc::gen::inRange(50, 500), to = from + 1;
  const Vec2 foot{low, 0}, head{high, 8}, along = glm::normalize(head - foot);
  const double length = glm::distance(head, foot);
  const Vec2 across = 0.1 * Vec2{-along.y, along.x};
  const auto wall = [&](double begin, double end) {
    const Vec2 a = foot + begin * along, b = foot + end * along;
    return test::Points{a - across, a + across, b + across, b - across};
  };
  const FloorPlan hall =
      mended(drawn(rectangle({0, 0}, {12, 8}), {wall(-0.5, from), wall(to, length + 0.5)}));
  RC_PRE(hall.ring.size() == 1U);
  const double short_of = 0.001 * *rc::gen::inRange(-200, 250);

  const Closed result =
      closed(hall, {door(foot + (from + short_of) * along, foot + (to - short_of) * along)});

  RC_ASSERT(result.faults.empty());
  RC_ASSERT(result.plan.ring.size() == 2U);
}

}  // namespace
}  // namespace docent::floor::close_doors_test
