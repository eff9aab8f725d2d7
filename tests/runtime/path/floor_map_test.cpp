#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "tests/runtime/path/floors.h"

namespace docent::test::floor_map_test {
namespace {

TEST(Locate, KnowsInsideFromOutsideAndTheBox) {
  const Floor floor = floor_of(hall_with_a_box());
  const auto map = path::make_floor_map(floor);

  EXPECT_TRUE(path::is_inside(*map, {3, 4}));
  EXPECT_FALSE(path::is_inside(*map, {6, 4}));
  EXPECT_FALSE(path::is_inside(*map, {-1, -1}));
  EXPECT_FALSE(path::is_inside(*map, {std::numeric_limits<double>::quiet_NaN(), 1}));
  EXPECT_NEAR(path::clearance_at(*map, {3, 4}), 2, 1e-12);
  EXPECT_NEAR(path::clearance_at(*map, {6, 4}), 1, 1e-12);
  EXPECT_NEAR(path::clearance_at(*map, {-3, -4}), 5, 1e-12);
}

TEST(Locate, SeesAlongWallsAndNotThroughThem) {
  const Floor floor = floor_of(hall_with_a_box());
  const auto map = path::make_floor_map(floor);

  EXPECT_TRUE(path::can_see(*map, {1, 1}, {11, 1}));
  EXPECT_TRUE(path::can_see(*map, {1, 3}, {11, 3})) << "along the side of the box";
  EXPECT_FALSE(path::can_see(*map, {1, 4}, {11, 4}));
  EXPECT_FALSE(path::can_see(*map, {4, 2}, {8, 6})) << "through two corners of the box";
}

RC_GTEST_PROP(Locate, AgreesWithBruteForceEverywhere, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const Floor floor = floor_of(*plan);
  const auto map = path::make_floor_map(floor);

  for (int i = 0; i < 50; ++i) {
    const Vec2 point = random_point() * 1.2 - Vec2{1.2, 0.8};
    const double nearest = distance_to_nearest_wall(*plan, point);
    RC_ASSERT(std::abs(path::clearance_at(*map, point) - nearest) < 1e-12);
    if (nearest < 1e-9) continue;
    RC_ASSERT(path::is_inside(*map, point) == is_inside(*plan, point));
    if (!is_inside(*plan, point)) continue;
    const Site site = floor.diagram.site[path::region_at(*map, point)];
    RC_ASSERT(std::abs(distance_to_site(*plan, site, point) - nearest) < 1e-9);
  }
}

}  // namespace
}  // namespace docent::test::floor_map_test
