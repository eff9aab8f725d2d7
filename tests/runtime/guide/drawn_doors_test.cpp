#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/runtime/guide/doorway.h"

namespace docent::guide::drawn_doors_test {
namespace {

using test::Beside;
using test::Doorway;
using test::Passage;
using test::Walker;
using test::walled_doorway;

/// From the side from which it is pulled, `from` metres along the door from its middle.
Passage walk_through(const Doorway& it, double from, double rate = 60) {
  Walker walker(it);
  const std::uint32_t who = walker.enters(it.place(-4, from, 1));
  return walker.walk(who, it.place(2.5, 0, 1), 1 / rate);
}

/// `least`: radians or metres that the hand takes a leaf.
void expect_drawn_by_hand(const Passage& seen, double least) {
  EXPECT_TRUE(seen.arrived);
  EXPECT_GT(seen.by_hand, least);
  EXPECT_LE(seen.farthest_hand, 0.02);
  EXPECT_LT(seen.before_hand, 0.01);
  EXPECT_GT(seen.nearest, 0);
  EXPECT_FALSE(seen.hand_went_through);
  EXPECT_LT(seen.fastest_hand, 3);  // who walks swings theirs at 2
  EXPECT_LE(seen.feet_slid, 0.005);
  EXPECT_LT(seen.hardest, 10);  // neither starts nor stops with a jerk
}

TEST(ASlidingDoor, IsSlidByAHandOnItsBarAtAnyFrameRate) {
  for (const double width : {0.8, 1.0, 1.2})
    for (const double rate : {30.0, 60.0, 120.0}) {
      SCOPED_TRACE(testing::Message() << width << " m, " << rate << " frames a second");
      expect_drawn_by_hand(
          walk_through(walled_doorway(DoorOpens::Sliding, DoorHinge::A, width), 0, rate), 0.4);
    }
}

TEST(ASlidingDoor, IsSlidByHandWhereverOneComesFromAndOnWhicheverSideItHangs) {
  for (const DoorHinge hinge : {DoorHinge::A, DoorHinge::B, DoorHinge::Both})
    for (const double from : {-1.2, 0.0, 1.2}) {
      SCOPED_TRACE(testing::Message() << "from " << from << " m");
      const double width = hinge == DoorHinge::Both ? 2 : 1;
      expect_drawn_by_hand(walk_through(walled_doorway(DoorOpens::Sliding, hinge, width), from),
                           0.3);
    }
}

TEST(ASlidingDoor, OfTwoLeavesOpensBothAtOnce) {
  const Doorway it = walled_doorway(DoorOpens::Sliding, DoorHinge::Both, 2);
  Walker walker(it);
  const std::uint32_t who = walker.enters(it.place(-4, 0, 1));
  walker.crowd.send(who, 0, it.place(2.5, 0, 1), RouteKind::Shortest);
  Passage seen;
  for (int i = 0; i < 60 * 15; ++i) {
    walker.step(who, 1.0 / 60, seen);
    ASSERT_NEAR(walker.doors.leaves()[0].slid, walker.doors.leaves()[1].slid, 0.05);
  }
  EXPECT_GT(seen.most_open, 0.9);
}

TEST(ADoorToPull, IsPulledByAHandOnItsBarAtAnyFrameRate) {
  for (const DoorHinge hinge : {DoorHinge::A, DoorHinge::B})
    for (const double rate : {30.0, 60.0, 120.0}) {
      SCOPED_TRACE(testing::Message() << rate << " frames a second");
      expect_drawn_by_hand(walk_through(walled_doorway(DoorOpens::Pull, hinge, 0.9), 0, rate), 0.6);
    }
}

/// Bent to it, that shoulder first; the narrower the leaf, the farther it turns within reach.
TEST(ADoorToPull, IsPulledAsFarAsAnArmReachesFromWhereOneStands) {
  for (const auto& [width, least] :
       {std::pair{0.8, 0.75}, std::pair{0.9, 0.6}, std::pair{1.0, 0.6}, std::pair{1.2, 0.45}}) {
    SCOPED_TRACE(testing::Message() << width << " m");
    const Doorway it = walled_doorway(DoorOpens::Pull, DoorHinge::A, width);
    Walker walker(it);
    const std::uint32_t who = walker.enters(it.place(-4, 0, 1));
    float leaned = 0;
    Passage seen;
    walker.crowd.send(who, 0, it.place(2.5, 0, 1), RouteKind::Shortest);
    for (int i = 0; i < 60 * 25; ++i) {
      walker.step(who, 1.0 / 60, seen);
      leaned = std::max(leaned, walker.crowd[who].avatar.manner.bend.lean);
    }
    seen.arrived = walker.crowd[who].has_arrived;
    expect_drawn_by_hand(seen, least);
    EXPECT_GT(leaned, 0.1F);
    EXPECT_EQ(walker.crowd[who].avatar.manner.bend.lean, 0);
    EXPECT_EQ(walker.crowd[who].avatar.manner.bend.turn, 0);
  }
}

TEST(ADoorToPull, IsOpenFarEnoughForWhoHasPulledIt) {
  for (const double width : {0.8, 1.0})
    for (const double from : {-1.0, 0.0, 1.0}) {
      SCOPED_TRACE(testing::Message() << width << " m, from " << from << " m");
      const Passage seen = walk_through(walled_doorway(DoorOpens::Pull, DoorHinge::B, width), from);
      EXPECT_TRUE(seen.arrived);
      EXPECT_GT(seen.nearest, 0);
      EXPECT_GT(seen.most_open, 1.3);
      EXPECT_LT(seen.hardest, 10);
    }
}

TEST(ADoorToPull, OfTwoLeavesOpensOneOfThem) {
  const Doorway it = walled_doorway(DoorOpens::Pull, DoorHinge::Both, 2);
  const Passage seen = walk_through(it, 0);
  expect_drawn_by_hand(seen, 0.35);
  EXPECT_LT(seen.turned_by_itself + seen.by_hand, 1.6);
}

/// Among exhibits and other walls, on a way that goes on to one side.
TEST(ADoorToPull, IsPulledByHandInTheSampleMuseum) {
  const Doorway it = test::doorway(DoorOpens::Pull);
  Walker walker(it);
  const std::uint32_t who = walker.enters(it.place(-6, -0.8, 1));
  const Passage seen = walker.walk(who, it.place(4.5, -2.6, 1));
  expect_drawn_by_hand(seen, 0.5);
}

TEST(ADoorToPull, OpensByItselfWhereThereIsNoRoomBesideIt) {
  for (const DoorHinge hinge : {DoorHinge::A, DoorHinge::B}) {
    const Doorway it = walled_doorway(DoorOpens::Pull, hinge, 1, Beside{.a = 0.1, .b = 0.1});
    const Passage seen = walk_through(it, 0);
    EXPECT_TRUE(seen.arrived);
    EXPECT_EQ(seen.held_seconds, 0);
    EXPECT_GT(seen.before_hand, 1.2);
    EXPECT_GT(seen.nearest, 0);
  }
}

/// Somebody stands where a leaf will turn.
TEST(ADoorToPull, WaitsForWhoStandsBehindItsLeaf) {
  const Doorway it = walled_doorway(DoorOpens::Pull, DoorHinge::A, 0.9);
  Walker walker(it, 2);
  const std::uint32_t who = walker.enters(it.place(-4, 0, 1));
  const std::uint32_t other = walker.enters(it.place(-0.7, -0.3, 1));
  walker.crowd.send(who, 0, it.place(2.5, 0, 1), RouteKind::Shortest);
  const Leaf& leaf = walker.doors.leaves()[0];
  Passage seen;
  double room = 1, time = 0;
  const auto go_on_until = [&](double end) {
    for (; time < end; time += 1.0 / 60) {
      walker.step(who, 1.0 / 60, seen);
      room = std::min(
          room, distance_to_leaf(leaf.hung, leaf.angle, walker.crowd[other].avatar.body.position));
    }
  };
  go_on_until(11);
  EXPECT_GT(seen.by_hand, 0.2);
  EXPECT_LT(seen.most_open, 0.9);
  EXPECT_GT(room, it.museum.body_radius);
  walker.crowd.send(other, 0, it.place(-3, -1.5, 1), RouteKind::Shortest);
  go_on_until(30);
  seen.arrived = walker.crowd[who].has_arrived;
  EXPECT_GT(seen.most_open, 1.3);
  EXPECT_GT(room, it.museum.body_radius);
  expect_drawn_by_hand(seen, 0.35);
}

TEST(ADrawnDoor, IsFoundOpenByWhoComesNextAndClosesOnceNobodyIsNear) {
  for (const DoorOpens opens : {DoorOpens::Pull, DoorOpens::Sliding}) {
    const Doorway it = walled_doorway(opens, DoorHinge::B, 1);
    Walker walker(it);
    const std::uint32_t who = walker.enters(it.place(-4, 0, 1));
    walker.walk(who, it.place(1.8, 0, 1));
    const Passage back = walker.walk(who, it.place(-4, 0, -1));
    EXPECT_TRUE(back.arrived);
    EXPECT_EQ(back.held_seconds, 0);
    EXPECT_GT(back.nearest, 0);
    Passage later;
    for (int i = 0; i < 60 * 12; ++i) walker.step(who, 1.0 / 60, later);
    for (const Leaf& leaf : walker.doors.leaves()) EXPECT_EQ(test::amount_of(leaf), 0);
  }
}

TEST(ADrawnDoor, LetsTwoThroughWhoComeFromEitherSide) {
  for (const DoorOpens opens : {DoorOpens::Pull, DoorOpens::Sliding}) {
    const Doorway it = walled_doorway(opens, DoorHinge::A, 1.2);
    Walker walker(it, 2);
    const std::uint32_t one = walker.enters(it.place(-4, 0, 1));
    const std::uint32_t other = walker.enters(it.place(4.5, 0.3, -1));
    Passage seen;
    for (int i = 0; i < 30; ++i) walker.step(one, 1.0 / 60, seen);
    walker.crowd.send(one, 0, it.place(3, -1, 1), RouteKind::Shortest);
    walker.crowd.send(other, 0, it.place(-3, 1, -1), RouteKind::Shortest);
    std::size_t collisions = 0;
    for (int i = 0; i < 60 * 60; ++i) {
      walker.step(one, 1.0 / 60, seen);
      collisions += walker.crowd.collisions();
    }
    EXPECT_TRUE(walker.crowd[one].has_arrived);
    EXPECT_TRUE(walker.crowd[other].has_arrived);
    EXPECT_EQ(collisions, 0U);
  }
}

TEST(ADrawnDoor, IsLeftByWhoIsToldSomethingElse) {
  for (const DoorOpens opens : {DoorOpens::Pull, DoorOpens::Sliding})
    for (const double after : {2.0, 4.0, 5.5, 6.0, 6.5, 7.0, 7.5}) {
      SCOPED_TRACE(testing::Message() << "after " << after << " s");
      const Doorway it = walled_doorway(opens, DoorHinge::A, 0.9);
      Walker walker(it);
      const std::uint32_t who = walker.enters(it.place(-4, 0, 1));
      walker.crowd.send(who, 0, it.place(2.5, 0, 1), RouteKind::Shortest);
      Passage seen;
      for (double time = 0; time < after; time += 1.0 / 60) walker.step(who, 1.0 / 60, seen);
      const Passage back = walker.walk(who, it.place(-4.5, 1, 1));
      EXPECT_TRUE(back.arrived);
      EXPECT_LT(back.fastest_hand, 3);
      for (int i = 0; i < 60; ++i) walker.step(who, 1.0 / 60, seen);
      EXPECT_FALSE(holds(walker.crowd[who].avatar.manner));
    }
}

}  // namespace
}  // namespace docent::guide::drawn_doors_test
