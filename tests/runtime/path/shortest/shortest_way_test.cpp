#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/model/none.h"
#include "runtime/path/shortest/make_hub_labels.h"
#include "tests/runtime/path/floors.h"

namespace docent::test::shortest_way_test {
namespace {

constexpr double exact = 1e-9;  // Metres.

path::Way shortest(const path::FloorMap& map, Vec2 from, Vec2 to, double radius) {
  return path::route(map, {.kind = RouteKind::Shortest, .from = from, .to = to, .radius = radius});
}

TEST(ShortestWay, RollsRoundACornerOnAnArc) {
  const Floor floor = floor_of(hall_with_a_box());
  const auto map = path::make_floor_map(floor);
  const double radius = 0.5;

  const path::Way way = shortest(*map, {3, 4}, {9, 4}, radius);

  // Up to the circle about (5, 5), over it, along the box, and the same down again.
  const double to_corner = std::sqrt(2.0 * 2.0 + 1.0 * 1.0);
  const double turn = std::atan2(1, 2) + std::asin(radius / to_corner);
  const double tangent = std::sqrt(to_corner * to_corner - radius * radius);
  EXPECT_EQ(way.status, path::RouteStatus::Ok);
  EXPECT_NEAR(way.length, 2 * (tangent + radius * turn) + 2, exact);
  EXPECT_NEAR(way.clearance_min, radius, exact);
  EXPECT_NEAR(polyline_length(way.points), way.length, 0.01);
}

TEST(ShortestWay, IsAStraightLineWhereNothingStands) {
  const Floor floor = floor_of(hall_with_a_box());
  const auto map = path::make_floor_map(floor);

  const path::Way way = shortest(*map, {1, 1}, {11, 1.5}, 0.25);

  EXPECT_EQ(way.points, (std::vector<Vec2>{{1, 1}, {11, 1.5}}));
  EXPECT_NEAR(way.length, std::hypot(10, 0.5), exact);
  EXPECT_NEAR(way.clearance_min, 1, exact);
  const path::RouteQuery briefly{
      .from = {1, 1}, .to = {11, 1.5}, .radius = 0.25, .tell_clearance = false};
  EXPECT_EQ(path::route(*map, briefly).clearance_min, 0.25);
}

TEST(ShortestWay, FitsThroughADoorOfTwiceItsRadiusAndNotThroughANarrowerOne) {
  const Floor floor = floor_of(two_rooms(0.8));
  const auto map = path::make_floor_map(floor);

  EXPECT_EQ(shortest(*map, {1, 2}, {7, 2.5}, 0.4).status, path::RouteStatus::Ok);
  EXPECT_EQ(shortest(*map, {1, 2}, {7, 2.5}, 0.4 + 1e-6).status, path::RouteStatus::NoRoute);
}

TEST(ShortestWay, GoesRoundOneColumnFarFromAllElse) {
  // All that lies between corners is a metre: what lies between them and the ends is much more.
  const Floor floor =
      floor_of(drawn(rectangle({0, 0}, {80, 40}), {rectangle({40, 20}, {41, 21})}), {0, 0.25});
  const auto map = path::make_floor_map(floor);

  const path::Way point = shortest(*map, {1, 20.75}, {79, 20.75}, 0);
  const path::Way disc = shortest(*map, {1, 20.75}, {79, 20.75}, 0.25);

  EXPECT_NEAR(point.length, std::hypot(39, 0.25) + 1 + std::hypot(38, 0.25), exact);
  EXPECT_EQ(disc.status, path::RouteStatus::Ok);
  EXPECT_GT(disc.length, point.length);
  EXPECT_LT(disc.length, point.length + 0.02);
}

TEST(ShortestWay, SaysWhichEndIsBlocked) {
  const Floor floor = floor_of(hall_with_a_box());
  const auto map = path::make_floor_map(floor);

  EXPECT_EQ(shortest(*map, {0.2, 4}, {9, 4}, 0.25).status, path::RouteStatus::StartBlocked);
  EXPECT_EQ(shortest(*map, {3, 4}, {6, 4}, 0).status, path::RouteStatus::GoalBlocked);
  EXPECT_EQ(shortest(*map, {3, 4}, {13, 4}, 0).status, path::RouteStatus::GoalBlocked);
  EXPECT_EQ(shortest(*map, {0.25, 4}, {9, 4}, 0.25).status, path::RouteStatus::Ok)
      << "touching is free";
}

TEST(ShortestWay, StaysPutWhenItIsThereAlready) {
  const Floor floor = floor_of(hall_with_a_box());
  const auto map = path::make_floor_map(floor);

  const path::Way way = shortest(*map, {3, 4}, {3, 4}, 0.25);

  EXPECT_EQ(way.status, path::RouteStatus::Ok);
  EXPECT_EQ(way.length, 0);
}

TEST(ShortestWay, LeavesAndReachesCornersOfWalls) {
  const Floor floor = floor_of(hall_with_a_box());
  const auto map = path::make_floor_map(floor);

  EXPECT_NEAR(shortest(*map, {5, 3}, {7, 5}, 0).length, 4, exact);
  EXPECT_NEAR(shortest(*map, {5, 3}, {5, 5}, 0).length, 2, exact);
  EXPECT_NEAR(shortest(*map, {0, 0}, {5, 3}, 0).length, std::hypot(5, 3), exact);
}

TEST(ShortestWay, IsSearchedWhereLabelsWouldBeTooMany) {
  Floor floor = floor_of(hall_with_a_box());
  const double labelled = shortest(*path::make_floor_map(floor), {3, 4}, {9, 4}, 0).length;

  floor.hub_labels[0] = path::make_hub_labels(floor.plan, floor.tangent_graphs[0], {}, 3);

  EXPECT_FALSE(floor.hub_labels[0].has_labels());
  EXPECT_FALSE(path::try_hub_labels(floor.plan, floor.tangent_graphs[0], {}, 3).far_too_many)
      << "without a core, nothing is known of other radii";
  EXPECT_NEAR(shortest(*path::make_floor_map(floor), {3, 4}, {9, 4}, 0).length, labelled, exact);
}

TEST(ShortestWay, PassesACornerThatTwoObstaclesShareAndNotBetweenThem) {
  for (const double x : {4.0, 4.5}) {  // On the left the shared corner is straight, or juts out.
    const Vec2 shared{5, 3}, tip{6, 4}, end{x, 2};
    const Floor floor = floor_of(
        drawn(rectangle({0, 0}, {12, 8}), {{shared, end, {10, 2}}, {tip, shared, {11, 4}}}),
        {0, 0.001});
    const auto map = path::make_floor_map(floor);

    const double expected = glm::distance({8, 6}, tip) + glm::distance(tip, shared) +
                            glm::distance(shared, end) + glm::distance(end, {5, 1.5});
    EXPECT_NEAR(shortest(*map, {8, 6}, {5, 1.5}, 0).length, expected, exact);
    EXPECT_NEAR(shortest(*map, {8, 6}, {5, 1.5}, 0.001).length, expected, 0.01);
    EXPECT_NEAR(shortest(*map, {8, 6}, shared, 0).length, glm::distance({8, 6}, shared), exact);
    EXPECT_NEAR(shortest(*map, {8, 3}, {8, 6}, 0).length, std::sqrt(10.0) + std::sqrt(13.0), exact)
        << "between them is a wall";
  }
}

TEST(ShortestWay, IsDefinedForNumbersThatAreNone) {
  const Floor floor = floor_of(hall_with_a_box());
  const auto map = path::make_floor_map(floor);
  const double nan = std::numeric_limits<double>::quiet_NaN();

  for (const RouteKind kind : {RouteKind::Shortest, RouteKind::Skeleton, RouteKind::Offset})
    for (const double bad : {nan, infinity, -infinity, 1e300}) {
      EXPECT_EQ(path::route(*map, {.kind = kind, .from = {bad, 1}, .to = {1, 1}}).status,
                path::RouteStatus::StartBlocked);
      EXPECT_EQ(path::route(*map, {.kind = kind, .from = {1, 1}, .to = {1, bad}}).status,
                path::RouteStatus::GoalBlocked);
      path::route(*map, {.kind = kind, .from = {1, 1}, .to = {2, 1}, .radius = bad, .offset = bad});
    }
}

RC_GTEST_PROP(ShortestWay, IsAsShortAsBruteForceFinds, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const Floor floor = floor_of(*plan);
  const auto map = path::make_floor_map(floor);
  const Vec2 from = random_point(), to = random_point();
  RC_PRE(is_inside(*plan, from) && is_inside(*plan, to));

  const path::Way way = shortest(*map, from, to, 0);

  const double expected = brute_force_length(*plan, from, to);
  RC_ASSERT((way.status == path::RouteStatus::Ok) == std::isfinite(expected));
  if (way.status == path::RouteStatus::Ok) RC_ASSERT(std::abs(way.length - expected) < exact);
}

RC_GTEST_PROP(ShortestWay, KeepsItsDistanceAndIsAMetric, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const double small = *rc::gen::inRange(0, 60) / 100.0;
  const double large = small + *rc::gen::inRange(1, 40) / 100.0;
  const Floor floor = floor_of(*plan, {small, large});
  const auto map = path::make_floor_map(floor);
  const Vec2 a = random_point(), b = random_point(), c = random_point();
  for (const Vec2 p : {a, b, c})
    RC_PRE(is_inside(*plan, p) && distance_to_nearest_wall(*plan, p) > large);

  const path::Way ab = shortest(*map, a, b, small), ba = shortest(*map, b, a, small);
  const path::Way bc = shortest(*map, b, c, small), ac = shortest(*map, a, c, small);
  const path::Way wide = shortest(*map, a, b, large);

  RC_ASSERT(ab.status == ba.status);
  if (wide.status == path::RouteStatus::Ok) {
    RC_ASSERT(ab.status == path::RouteStatus::Ok);
    RC_ASSERT(wide.length >= ab.length - exact);
  }
  RC_PRE(ab.status == path::RouteStatus::Ok);
  RC_ASSERT(std::abs(ab.length - ba.length) < exact);
  RC_ASSERT(ab.length >= glm::distance(a, b) - exact);
  RC_ASSERT(ab.points.front() == a && ab.points.back() == b);
  for (const Vec2 point : ab.points)
    RC_ASSERT(distance_to_nearest_wall(*plan, point) >= small - 1e-6);
  RC_ASSERT(sampled_clearance(*plan, ab.points) >= small - 1e-3 - 1e-6);
  RC_ASSERT(!crosses_a_wall(*plan, ab.points));
  if (bc.status == path::RouteStatus::Ok) {
    RC_ASSERT(ac.status == path::RouteStatus::Ok);
    RC_ASSERT(ac.length <= ab.length + bc.length + exact);
  }
}

}  // namespace
}  // namespace docent::test::shortest_way_test
