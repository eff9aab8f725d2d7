#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/runtime/path/floors.h"

namespace docent::test::medial_axis_way_test {
namespace {

path::Way skeleton(const path::FloorMap& map, Vec2 from, Vec2 to, double radius,
                   bool widest = false) {
  return path::route(
      map,
      {.kind = RouteKind::Skeleton, .from = from, .to = to, .radius = radius, .widest = widest});
}

TEST(MedialAxisWay, GoesAlongTheMiddleOfACorridor) {
  const Floor floor = floor_of(drawn(rectangle({0, 0}, {20, 2})));
  const auto map = path::make_floor_map(floor);

  const path::Way way = skeleton(*map, {4, 0.5}, {15, 1.75}, 0.25);

  ASSERT_EQ(way.status, path::RouteStatus::Ok);
  EXPECT_NEAR(way.length, 0.5 + 11 + 0.75, 1e-9);
  EXPECT_NEAR(way.clearance_min, 0.25, 1e-9);
}

TEST(MedialAxisWay, FollowsTheParabolaBetweenAWallAndACorner) {
  // Above the corner at (10, 1), which a wall from below ends at: focus 3 m under the ceiling.
  const Floor floor =
      floor_of(drawn({{0, 0}, {9.99, 0}, {10, 1}, {10.01, 0}, {20, 0}, {20, 4}, {0, 4}}));
  const auto map = path::make_floor_map(floor);

  const path::Way way = skeleton(*map, {10, 2.5}, {10.75, 2.4}, 0.25);

  // From the lowest place of the parabola, straight below the ceiling's middle height, the curve
  // y = 2.5 - u^2 / 6: its arc length to u is known in closed form.
  ASSERT_EQ(way.status, path::RouteStatus::Ok);
  EXPECT_GT(way.points.size(), 3U);
  for (const Vec2 point : way.points) {
    const double to_ceiling = 4 - point.y, to_corner = glm::distance(point, Vec2{10, 1});
    EXPECT_LT(std::abs(to_ceiling - to_corner), 0.02) << point.x << " " << point.y;
  }
}

TEST(MedialAxisWay, PrefersTheWiderOfTwoPassagesWhenAskedTo) {
  // A box nearer to the lower wall: 1 m below it, 2 m above.
  const Floor floor = floor_of(drawn(rectangle({0, 0}, {12, 5}), {rectangle({5, 1}, {7, 3})}));
  const auto map = path::make_floor_map(floor);

  const path::Way shorter = skeleton(*map, {2, 0.75}, {10, 0.75}, 0.25);
  const path::Way widest = skeleton(*map, {2, 1}, {10, 1}, 0, true);

  EXPECT_NEAR(shorter.clearance_min, 0.5, 1e-9);
  EXPECT_NEAR(widest.clearance_min, 1, 1e-9);
}

RC_GTEST_PROP(MedialAxisWay, ExistsWhereverTheShortestDoesAndKeepsTheRadius, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const double radius = *rc::gen::inRange(0, 60) / 100.0;
  const Floor floor = floor_of(*plan, {radius});
  const auto map = path::make_floor_map(floor);
  const Vec2 from = random_point(), to = random_point();
  for (const Vec2 p : {from, to})
    RC_PRE(is_inside(*plan, p) && distance_to_nearest_wall(*plan, p) > radius);

  const path::Way way = skeleton(*map, from, to, radius);
  const path::Way shortest = path::route(*map, {.from = from, .to = to, .radius = radius});

  RC_ASSERT(way.status == shortest.status);
  RC_PRE(way.status == path::RouteStatus::Ok);
  RC_ASSERT(way.length >= shortest.length - 1e-9);
  RC_ASSERT(way.points.front() == from && way.points.back() == to);
  RC_ASSERT(std::abs(sampled_clearance(*plan, way.points) - way.clearance_min) < 0.01);
  RC_ASSERT(way.clearance_min >= radius - 1e-6);
  RC_ASSERT(!crosses_a_wall(*plan, way.points));
}

RC_GTEST_PROP(MedialAxisWay, FindsTheWidestDiscThatStillFits, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const Floor floor = floor_of(*plan);
  const auto map = path::make_floor_map(floor);
  const Vec2 from = random_point(), to = random_point();
  RC_PRE(is_inside(*plan, from) && is_inside(*plan, to));

  const path::Way widest = skeleton(*map, from, to, 0, true);

  // The tangent graph knows nothing of the medial axis: a disc a little smaller fits, one a little
  // larger does not.
  RC_PRE(widest.status == path::RouteStatus::Ok && widest.clearance_min > 0.01);
  const auto fits = [&](double radius) {
    return path::route(*map, {.from = from, .to = to, .radius = radius}).status ==
           path::RouteStatus::Ok;
  };
  RC_ASSERT(fits(widest.clearance_min - 1e-6));
  RC_ASSERT(!fits(widest.clearance_min + 1e-6));
}

}  // namespace
}  // namespace docent::test::medial_axis_way_test
