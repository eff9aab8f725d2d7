#include "runtime/path/shortest/radius_maps.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "runtime/path/floor_map.h"
#include "runtime/path/shortest/shortest_way.h"
#include "tests/runtime/path/floors.h"

namespace docent::test::radius_maps_test {
namespace {

/// Waits until the background has made a radius, as long as it takes.
void wait_for(const path::FloorMap& map, double radius) {
  while (!map.shortest_ways().find(radius))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(RadiusMaps, HaveTheClassesOfTheDatabaseAtOnce) {
  const Floor floor = floor_of(hall_with_a_box(), {0, 0.25});
  const path::FloorMap map(floor);

  EXPECT_NE(map.shortest_ways().find(0), nullptr);
  EXPECT_NE(map.shortest_ways().find(0.25), nullptr);
}

TEST(RadiusMaps, MakeARadiusThatNobodyAskedForBeforeInTheBackground) {
  const Floor floor = floor_of(hall_with_a_box());
  const path::FloorMap map(floor);
  const path::RouteQuery query{
      .kind = RouteKind::Shortest, .from = {3, 4}, .to = {9, 4}, .radius = 0.4};

  EXPECT_EQ(map.shortest_ways().find(0.4), nullptr);
  const path::Way at_once = path::route(map, query);
  wait_for(map, 0.4);
  const path::Way later = path::route(map, query);

  EXPECT_EQ(at_once.status, path::RouteStatus::Ok);
  EXPECT_NEAR(at_once.length, later.length, 1e-9);
}

TEST(RadiusMaps, MayGoWhileARadiusIsBeingMade) {
  const Floor floor = floor_of(hall_with_a_box());
  for (int k = 0; k < 20; ++k) {
    const path::FloorMap map(floor);
    EXPECT_EQ(map.shortest_ways().find(0.1 + 0.01 * k), nullptr);
  }
}

RC_GTEST_PROP(ShortestWay, IsTheSameByLabelsAndBySearch, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const double radius = *rc::gen::inRange(0, 80) / 100.0;
  const Floor floor = floor_of(*plan, {radius});
  const path::FloorMap map(floor);
  const auto labels = map.shortest_ways().find(radius);
  RC_ASSERT(static_cast<bool>(labels));
  for (int k = 0; k < 12; ++k) {
    const Vec2 from = random_point(), to = random_point();
    if (!map.has_room(from, radius) || !map.has_room(to, radius)) continue;

    auto straight = path::straight_way(*labels, from, to);
    const path::Way by_labels = straight ? *std::move(straight) : path::bent_way(*labels, from, to);
    const path::Way by_search = path::search_tangents(map.search(), radius, from, to);

    RC_ASSERT(by_labels.status == by_search.status);
    RC_ASSERT(std::abs(by_labels.length - by_search.length) < 1e-6);
    RC_ASSERT(std::abs(polyline_length(by_labels.points) - by_labels.length) <
              0.01 + 0.02 * by_labels.length);
    if (by_labels.status == path::RouteStatus::Ok)
      RC_ASSERT(sampled_clearance(*plan, by_labels.points) >= radius - 1e-3 - 1e-6);
  }
}

}  // namespace
}  // namespace docent::test::radius_maps_test
