#include "runtime/path/round_corners.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/runtime/path/floors.h"

namespace docent::test::round_corners_test {
namespace {

double sharpest_turn(const std::vector<Vec2>& points) {
  double sharpest = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec2 in = points[i] - points[i - 1], out = points[i + 1] - points[i];
    if (glm::length(in) > 1e-6 && glm::length(out) > 1e-6)
      sharpest = std::max(sharpest, std::abs(std::atan2(cross(in, out), dot(in, out))));
  }
  return sharpest;
}

TEST(RoundCorners, JoinsAndLeavesTheAxisSmoothly) {
  const Floor floor = floor_of(drawn(rectangle({0, 0}, {20, 4})));
  const auto map = path::make_floor_map(floor);
  path::RouteQuery query{
      .kind = RouteKind::Skeleton, .from = {4, 0.5}, .to = {15, 3.25}, .radius = 0.25};

  const path::Way sharp = path::route(*map, query);
  query.smooth = true;
  const path::Way smooth = path::route(*map, query);

  ASSERT_EQ(smooth.status, path::RouteStatus::Ok);
  EXPECT_NEAR(sharpest_turn(sharp.points), std::numbers::pi / 2, 1e-6);
  EXPECT_LT(sharpest_turn(smooth.points), std::numbers::pi / 9);
  // Each quarter turn about 1 m (the second line is 1.25 m long) saves 2 - pi / 2.
  EXPECT_NEAR(sharp.length - smooth.length, 2 * (2 - std::numbers::pi / 2), 0.01);
  EXPECT_NEAR(polyline_length(smooth.points), smooth.length, 1e-6);
}

RC_GTEST_PROP(RoundCorners, KeepsTheEndsTheRadiusAndTheWalls, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const double radius = *rc::gen::inRange(0, 40) / 100.0;
  const Floor floor = floor_of(*plan);
  const auto map = path::make_floor_map(floor);
  path::RouteQuery query{.kind = *rc::gen::element(RouteKind::Skeleton, RouteKind::Offset),
                         .from = random_point(),
                         .to = random_point(),
                         .radius = radius,
                         .offset = *rc::gen::inRange(10, 150) / 100.0};
  for (const Vec2 p : {query.from, query.to})
    RC_PRE(is_inside(*plan, p) && distance_to_nearest_wall(*plan, p) > radius);

  const path::Way sharp = path::route(*map, query);
  query.smooth = true;
  const path::Way smooth = path::route(*map, query);

  RC_ASSERT(smooth.status == sharp.status);
  RC_PRE(smooth.status == path::RouteStatus::Ok);
  RC_ASSERT(smooth.points.front() == query.from && smooth.points.back() == query.to);
  RC_ASSERT(smooth.length <= sharp.length + 1e-6);
  RC_ASSERT(std::abs(polyline_length(smooth.points) - smooth.length) < 0.01 * smooth.length + 0.01);
  RC_ASSERT(sampled_clearance(*plan, smooth.points) >= radius - 2e-3);
  RC_ASSERT(!crosses_a_wall(*plan, smooth.points));
}

}  // namespace
}  // namespace docent::test::round_corners_test
