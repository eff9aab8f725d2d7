#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/runtime/path/floors.h"

namespace docent::test::offset_way_test {
namespace {

path::Way along_wall(const path::FloorMap& map, Vec2 from, Vec2 to, double offset, path::Hand hand,
                     double radius = 0) {
  return path::route(map, {.kind = RouteKind::Offset,
                           .from = from,
                           .to = to,
                           .radius = radius,
                           .offset = offset,
                           .hand = hand});
}

TEST(OffsetWay, WalksRoundARoomOnTheChosenHand) {
  const Floor floor = floor_of(drawn(rectangle({0, 0}, {12, 8})));
  const auto map = path::make_floor_map(floor);
  const Vec2 from{3, 1}, to{9, 1};  // Both on the curve at 1 m, along the south wall.

  const path::Way right = along_wall(*map, from, to, 1, path::Hand::Right);
  const path::Way left = along_wall(*map, from, to, 1, path::Hand::Left);
  const path::Way shorter = along_wall(*map, from, to, 1, path::Hand::Shorter);

  EXPECT_NEAR(right.length, 6, 1e-9) << "eastwards the south wall is on the right";
  EXPECT_NEAR(left.length, 2 * (10 + 6) - 6, 1e-9);
  EXPECT_NEAR(shorter.length, 6, 1e-9);
  EXPECT_NEAR(left.clearance_min, 1, 1e-9);
}

TEST(OffsetWay, TurnsRoundReflexCornersOnArcs) {
  const Floor floor = floor_of(drawn({{0, 0}, {10, 0}, {10, 10}, {6, 10}, {6, 4}, {0, 4}}));
  const auto map = path::make_floor_map(floor);

  const path::Way way = along_wall(*map, {2, 3.5}, {6.5, 8}, 0.5, path::Hand::Left);

  EXPECT_EQ(way.status, path::RouteStatus::Ok);
  EXPECT_NEAR(way.length, 4 + 0.5 * std::acos(0.0) + 4, 1e-9);
}

TEST(OffsetWay, TakesTheMedialAxisThroughADoorThatIsTooNarrow) {
  const Floor floor = floor_of(two_rooms(1));
  const auto map = path::make_floor_map(floor);

  const path::Way way = along_wall(*map, {2, 1}, {6.2, 1}, 1, path::Hand::Shorter);

  ASSERT_EQ(way.status, path::RouteStatus::Ok);
  EXPECT_NEAR(way.clearance_min, 0.5, 1e-9);
  const bool through_the_middle = std::ranges::any_of(
      way.points, [](Vec2 p) { return std::abs(p.x - 4.1) < 0.5 && std::abs(p.y - 2) < 1e-6; });
  EXPECT_TRUE(through_the_middle);
}

TEST(OffsetWay, CrossesToAnIslandAlongTheMedialAxis) {
  const Floor floor = floor_of(hall_with_a_box());
  const auto map = path::make_floor_map(floor);

  const path::Way way = along_wall(*map, {1, 0.5}, {7.2, 4}, 0.5, path::Hand::Shorter, 0.15);

  ASSERT_EQ(way.status, path::RouteStatus::Ok);
  EXPECT_GT(sampled_clearance(floor.plan, way.points), 0.2 - 1e-6);
  EXPECT_FALSE(crosses_a_wall(floor.plan, way.points));
}

TEST(OffsetWay, PassesTheStopsOfATourInOrder) {
  const Floor floor = floor_of(hall_with_a_box());
  const auto map = path::make_floor_map(floor);
  const std::array<Vec2, 3> stops{Vec2{1, 1.5}, Vec2{11, 6}, Vec2{4.5, 4}};

  const path::Way way = path::tour(*map, {.kind = RouteKind::Offset, .radius = 0.25}, stops);

  ASSERT_EQ(way.status, path::RouteStatus::Ok);
  auto place = way.points.begin();
  for (const Vec2 stop : stops) {
    place = std::find(place, way.points.end(), stop);
    ASSERT_NE(place, way.points.end());
  }
}

RC_GTEST_PROP(OffsetWay, ExistsWhereverTheShortestDoesAndNeverCrossesAWall, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const double radius = *rc::gen::inRange(0, 50) / 100.0;
  const double offset = *rc::gen::inRange(10, 200) / 100.0;
  const path::Hand hand =
      *rc::gen::element(path::Hand::Shorter, path::Hand::Left, path::Hand::Right);
  const Floor floor = floor_of(*plan, {radius});
  const auto map = path::make_floor_map(floor);
  const Vec2 from = random_point(), to = random_point();
  for (const Vec2 p : {from, to})
    RC_PRE(is_inside(*plan, p) && distance_to_nearest_wall(*plan, p) > radius);

  const path::Way way = along_wall(*map, from, to, offset, hand, radius);
  const path::Way shortest = path::route(*map, {.from = from, .to = to, .radius = radius});

  RC_ASSERT(way.status == shortest.status);
  RC_PRE(way.status == path::RouteStatus::Ok);
  RC_ASSERT(way.length >= shortest.length - 1e-9);
  RC_ASSERT(way.points.front() == from && way.points.back() == to);
  RC_ASSERT(std::abs(polyline_length(way.points) - way.length) < 0.01 * way.length + 0.01);
  RC_ASSERT(sampled_clearance(*plan, way.points) >= radius - 1e-3 - 1e-6);
  RC_ASSERT(!crosses_a_wall(*plan, way.points));
}

}  // namespace
}  // namespace docent::test::offset_way_test
