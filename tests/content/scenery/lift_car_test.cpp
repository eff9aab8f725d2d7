#include "content/scenery/lift_car.h"

#include <gmock/gmock.h>

#include <numbers>
#include <span>

#include "runtime/model/geometry/polygon.h"
#include "tests/support/halls.h"

namespace docent::scenery::lift_car_test {
namespace {

using test::HallMaker;

constexpr Placement before_the_south_wall{{5, 0.4}, -std::numbers::pi / 2};

double area_of(const FloorPlan& plan) {
  double area = 0;
  for (const Ring& ring : plan.ring)
    area += signed_area(std::span(plan.vertex).subspan(ring.first, ring.count));
  return area;
}

TEST(LiftCar, IsAnAlcoveBehindTheWallThatOneLooksAt) {
  FloorPlan plan = HallMaker().room({0, 0}, {10, 6}).block({2, 2}, {3, 3}).plan;
  const double before = area_of(plan);

  EXPECT_EQ(add_lift_car(before_the_south_wall, plan).size(), 2U);

  EXPECT_GT(area_of(plan), before + 1);
  EXPECT_TRUE(contains(std::span(plan.vertex).first(plan.ring[0].count), Vec2{5, -1}));
  for (std::uint32_t v = 0; v < plan.next.size(); ++v) EXPECT_LT(plan.next[v], plan.vertex.size());
}

TEST(LiftCar, LeavesOtherRingsAsTheyWere) {
  FloorPlan plan = HallMaker().room({0, 0}, {10, 6}).block({2, 2}, {3, 3}).plan;

  add_lift_car(before_the_south_wall, plan);

  EXPECT_EQ(plan.vertex[plan.ring[1].first], Vec2(2, 2));
  EXPECT_EQ(plan.ring[1].count, 4U);
}

TEST(LiftCar, IsNotBuiltIntoARoomBehindTheWall) {
  FloorPlan plan = HallMaker().room({0, 0}, {10, 6}).room({0, -6}, {10, -0.4}).plan;
  const FloorPlan before = plan;

  EXPECT_TRUE(add_lift_car(before_the_south_wall, plan).empty());
  EXPECT_EQ(plan.vertex, before.vertex);
}

TEST(LiftCar, IsNotBuiltWhereNoWallIsNear) {
  FloorPlan plan = HallMaker().room({0, 0}, {10, 6}).plan;

  EXPECT_TRUE(add_lift_car({{5, 3}, -std::numbers::pi / 2}, plan).empty());
}

TEST(LiftCar, NeedsAWallAsWideAsItsDoor) {
  FloorPlan plan = HallMaker().room({0, 0}, {10, 6}).plan;

  EXPECT_TRUE(add_lift_car({{0.3, 0.4}, -std::numbers::pi / 2}, plan).empty());
}

}  // namespace
}  // namespace docent::scenery::lift_car_test
