#include "runtime/guide/doors.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/runtime/guide/doorway.h"

namespace docent::guide::doors_test {
namespace {

using test::Doorway;
using test::doorway;
using test::Passage;
using test::Walker;

void expect_opened_by_hand(const Passage& seen) {
  EXPECT_TRUE(seen.arrived);
  EXPECT_GT(seen.most_open, 0.4);
  EXPECT_LE(seen.farthest_hand, 0.02);
  EXPECT_LT(seen.turned_by_itself, 1e-3);
  EXPECT_GT(seen.nearest, 0);
}

TEST(ADoor, IsPushedWithAHandOnItsBarWhileItTurnsAtAnyFrameRate) {
  for (const DoorHinge hinge : {DoorHinge::Both, DoorHinge::A, DoorHinge::B})
    for (const double side : {-1.0, 1.0})
      for (const double rate : {30.0, 60.0, 120.0}) {
        const Doorway it = doorway(DoorOpens::Push, hinge, hinge == DoorHinge::Both ? 2 : 1.1);
        Walker walker(it);
        const std::uint32_t who = walker.enters(it.place(3 * side, 0, -side));
        const Passage seen = walker.walk(who, it.place(-2.5 * side, 0, -side), 1 / rate);
        expect_opened_by_hand(seen);
      }
}

TEST(ADoor, IsPushedWhereverOneGoesThroughIt) {
  for (const double width : {2.0, 1.1})
    for (const double along : {-0.2, -0.1, 0.0, 0.1, 0.2})
      for (const double from : {0.0, 0.5}) {
        const Doorway it =
            doorway(DoorOpens::Push, width > 1.5 ? DoorHinge::Both : DoorHinge::A, width);
        const double scale = width / 2;
        Walker walker(it);
        const std::uint32_t who = walker.enters(it.place(-3, scale * (along + from), 1));
        const Passage seen = walker.walk(who, it.place(2.5, scale * along, 1));
        expect_opened_by_hand(seen);
      }
}

TEST(ADoor, IsFoundOpenByWhoComesNextAndClosesOnceNobodyIsNear) {
  const Doorway it = doorway(DoorOpens::Push);
  Walker walker(it);
  const std::uint32_t who = walker.enters(it.place(-3, 0, 1));
  walker.walk(who, it.place(2.5, 0, 1));
  const Passage back = walker.walk(who, it.place(-3.5, 0, -1));
  EXPECT_TRUE(back.arrived);
  EXPECT_EQ(back.held_seconds, 0);
  EXPECT_GT(back.nearest, 0);

  Passage later;
  for (int i = 0; i < 60 * 12; ++i) walker.step(who, 1.0 / 60, later);
  for (const Leaf& leaf : walker.doors.leaves()) EXPECT_EQ(leaf.angle, 0);
}

TEST(ADoor, ThatSlidesOrComesTowardsTheGuideIsOpenBeforeItIsReached) {
  for (const DoorOpens opens : {DoorOpens::Pull, DoorOpens::Sliding})
    for (const double side : {-1.0, 1.0}) {
      const Doorway it = doorway(opens);
      Walker walker(it);
      const std::uint32_t who = walker.enters(it.place(3.5 * side, 0, -side));
      const Passage seen = walker.walk(who, it.place(-2.5 * side, 0, -side));
      EXPECT_TRUE(seen.arrived);
      EXPECT_GT(seen.nearest, 0);
      if (opens == DoorOpens::Pull && side > 0) expect_opened_by_hand(seen);
    }
}

TEST(ADoor, LetsThroughWhoBeginsRightBeforeIt) {
  for (const DoorHinge hinge : {DoorHinge::Both, DoorHinge::A})
    for (const double metres : {0.5, 0.3, 0.2, 0.1, 0.05, 0.01})
      for (const double along : {-0.3, 0.0, 0.3}) {
        const Doorway it = doorway(DoorOpens::Push, hinge, hinge == DoorHinge::Both ? 2 : 1.1);
        Walker walker(it);
        const std::uint32_t who = walker.enters(it.place(-metres, along, 1));
        EXPECT_TRUE(walker.walk(who, it.place(2.5, 0, 1)).arrived) << metres << ", " << along;
      }
}

TEST(ADoor, IsPassedInItsMiddleByTheShortestWayToo) {
  const Doorway it = doorway(DoorOpens::Push);
  Walker walker(it);
  const std::uint32_t who = walker.enters(it.place(-2.5, 0.5, 1));
  walker.crowd.send(who, it.floor, it.place(2.5, 1.5, 1), RouteKind::Shortest);
  Passage seen;
  double nearest_to_middle = 1e9;
  const Vec2 middle = 0.5 * (it.it().a + it.it().b);
  for (int i = 0; i < 60 * 15; ++i) {
    walker.step(who, 1.0 / 60, seen);
    nearest_to_middle =
        std::min(nearest_to_middle, glm::distance(walker.crowd[who].avatar.body.position, middle));
  }
  EXPECT_LT(nearest_to_middle, 0.05);
  EXPECT_LE(seen.farthest_hand, 0.02);
  EXPECT_LT(seen.turned_by_itself, 1e-3);
  EXPECT_GT(seen.nearest, 0);
}

/// Another comes from the other side, sooner or later.
TEST(ADoor, ThatIsPushedDoesNotGoAheadOfTheHandOfWhoIsHeldUp) {
  for (const double width : {1.2, 2.0})
    for (const double later : {0.0, 0.5, 1.0, 1.5, 2.0}) {
      SCOPED_TRACE(testing::Message() << width << " m, " << later << " s later");
      const Doorway it = test::walled_doorway(DoorOpens::Push,
                                              width > 1.5 ? DoorHinge::Both : DoorHinge::A, width);
      Walker walker(it, 2);
      const std::uint32_t one = walker.enters(it.place(-4, 0, 1));
      const std::uint32_t other = walker.enters(it.place(4.5, 0.3, -1));
      Passage seen;
      walker.crowd.send(one, 0, it.place(3, -1, 1), RouteKind::Shortest);
      for (int i = 0; i < 60 * later; ++i) walker.step(one, 1.0 / 60, seen);
      walker.crowd.send(other, 0, it.place(-3, 1, -1), RouteKind::Shortest);
      for (int i = 0; i < 60 * 30; ++i) walker.step(one, 1.0 / 60, seen);
      EXPECT_TRUE(walker.crowd[one].has_arrived);
      EXPECT_TRUE(walker.crowd[other].has_arrived);
      EXPECT_LE(seen.farthest_hand, 0.02);
      EXPECT_LT(seen.ahead_of_hand, 1e-3);
      EXPECT_FALSE(holds(walker.crowd[one].avatar.manner));
    }
}

TEST(ADoor, SlowsWhoComesToIt) {
  const auto seconds_through = [](DoorOpens opens) {
    const Doorway it = doorway(opens);
    Walker walker(it);
    const std::uint32_t who = walker.enters(it.place(-3, 0, 1));
    walker.walk(who, it.place(2.5, 0, 1));
    return walker.crowd.clock();
  };
  const double open = seconds_through(DoorOpens::None), leaf = seconds_through(DoorOpens::Push);
  EXPECT_GT(leaf, open + 0.5);
  EXPECT_LT(leaf, open + 3);
}

}  // namespace
}  // namespace docent::guide::doors_test
