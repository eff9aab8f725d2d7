#include "runtime/model/geometry/treads.h"

#include <gtest/gtest.h>

#include <array>

namespace docent::treads_test {
namespace {

constexpr std::array<Vec2, 4> outline{{{1, 0}, {5, 0}, {5, 2}, {1, 2}}};

TEST(Treads, AreTheSameSeenFromBelowAndFromAbove) {
  const Treads up = treads_within(outline, {0.5, 1}, {5.5, 1}, 3.4);
  const Treads down = treads_within(outline, {5.5, 1}, {0.5, 1}, -3.4);

  ASSERT_EQ(up.count, 20);
  ASSERT_EQ(down.count, 20);
  for (int i = 0; i < 500; ++i) {
    const double at = 0.005 + 0.01 * i;
    EXPECT_NEAR(up.height_at(at), 3.4 + down.height_at(5 - at), 1e-9) << at;
  }
}

TEST(Treads, BeginAndEndLevelWithTheFloors) {
  const Treads treads = treads_between({0, 0}, {4, 0}, 0.6);

  EXPECT_EQ(treads.height_at(0), 0);
  EXPECT_EQ(treads.height_at(4), 0.6);
  EXPECT_EQ(treads.height_of(treads.count - 1), 0.6);
}

TEST(Treads, HaveNoPlaceInAHoleThatIsNotConvex) {
  FloorPlan plan;
  plan.vertex = {{0, 0}, {0, 2}, {4, 2}, {4, 1}, {1, 1}, {1, 0}};
  plan.ring = {{0, 6}};

  EXPECT_FALSE(hole_between(plan, {-1, 1.5}, {3, 1.5}));
}

}  // namespace
}  // namespace docent::treads_test
