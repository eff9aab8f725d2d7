#include "runtime/plan/traffic.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "runtime/path/floor_map.h"
#include "tests/runtime/path/floors.h"
#include "tests/support/halls.h"

namespace docent::plan::traffic_test {
namespace {

constexpr double radius = 0.25;

/// A corridor of 14 by 2 m, and two bodies in it that glide, since there is no motion.
class Corridor {
 public:
  Corridor() {
    test::HallMaker hall;
    hall.room({0, 0}, {14, 2});
    museum_.body_radius = radius;
    museum_.floors.push_back(test::floor_of(hall.plan, {radius + Museum::walking_room, radius}));
    building_.emplace(museum_, std::vector{path::make_floor_map(museum_.floors[0])});
    traffic_ = std::make_unique<Traffic>(museum_, nullptr, *building_, 0);
  }

  void enter(std::uint32_t who, Vec2 place) {
    WalkOrder order = order_of(who, place);
    order.enters = true;
    EXPECT_FALSE(traffic_->plan(order)->holds);
  }
  WalkOrder order_of(std::uint32_t who, Vec2 from) const {
    WalkOrder order;
    order.avatar = who;
    order.start.position = from;
    order.seconds = 1;
    return order;
  }
  Traffic& traffic() { return *traffic_; }
  /// Do the two come nearer to each other than their circles allow?
  bool meet() const {
    const crowd::Trajectory& a = *traffic_->reservations().trajectory_of(0);
    const crowd::Trajectory& b = *traffic_->reservations().trajectory_of(1);
    return crowd::first_impact(a, b, 2 * radius, 0).has_value();
  }

 private:
  Museum museum_;
  std::optional<path::BuildingMap> building_;
  std::unique_ptr<Traffic> traffic_;
};

TEST(Traffic, GoesRoundSomebodyWhomNobodyHasDetectedYet) {
  Corridor corridor;
  corridor.enter(0, {2, 1});
  corridor.enter(1, {6, 1});
  WalkOrder order = corridor.order_of(0, {2, 1});
  order.goal = Placement{{10, 1}, 0};

  const auto plan = corridor.traffic().plan(order);

  EXPECT_FALSE(plan->holds);
  EXPECT_TRUE(plan->is_whole);
  EXPECT_FALSE(corridor.meet());
}

TEST(Traffic, LooksAtThoseWhoWereDetectedFromTheBeginning) {
  Corridor corridor;
  corridor.enter(0, {2, 1});
  corridor.enter(1, {6, 1});
  WalkOrder order = corridor.order_of(0, {2, 1});
  order.goal = Placement{{10, 1}, 0};
  order.near.add(1, 0.5);

  const auto plan = corridor.traffic().plan(order);

  EXPECT_TRUE(plan->is_whole);
  EXPECT_FALSE(corridor.meet());
}

TEST(Nearby, KeepsTheSoonestWhereThereAreMoreThanItHolds) {
  Nearby near;
  for (std::uint32_t i = 0; i < 2 * Nearby::most; ++i)
    near.add(i, static_cast<double>(2 * Nearby::most - i));

  ASSERT_EQ(near.agents().size(), Nearby::most);
  for (std::uint32_t i = 0; i < Nearby::most; ++i)
    EXPECT_EQ(near.agents()[i], 2 * Nearby::most - 1 - i);
}

}  // namespace
}  // namespace docent::plan::traffic_test
