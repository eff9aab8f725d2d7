#include "runtime/input/staff_gesture.h"

#include <gtest/gtest.h>

namespace docent::test::staff_gesture_test {
namespace {

using Kind = input::InputEvent::Kind;

input::InputEvent event(Kind kind, std::uint32_t id, float x, float y) {
  return {.kind = kind, .contact = {id, x, y}};
}

/// Two fingers in opposite corners from time 1.
input::StaffGesture two_corners() {
  input::StaffGesture gesture;
  gesture.take(event(Kind::Down, 1, 0.02F, 0.05F), 0);
  gesture.take(event(Kind::Down, 2, 0.97F, 0.99F), 1);
  return gesture;
}

TEST(StaffGesture, IsTwoOppositeCornersForFiveSeconds) {
  input::StaffGesture gesture = two_corners();

  EXPECT_FALSE(gesture.is_made(5.9));
  EXPECT_TRUE(gesture.is_made(6.0));
  EXPECT_FALSE(gesture.is_made(7.0)) << "once";
}

TEST(StaffGesture, MayTremble) {
  input::StaffGesture gesture = two_corners();
  gesture.take(event(Kind::Move, 1, 0.03F, 0.06F), 3);

  EXPECT_TRUE(gesture.is_made(6.0));
}

TEST(StaffGesture, IsNotMadeByFingersThatLeaveTheirCorner) {
  input::StaffGesture gesture = two_corners();
  gesture.take(event(Kind::Move, 1, 0.5F, 0.5F), 3);
  gesture.take(event(Kind::Move, 1, 0.02F, 0.05F), 3.1);

  EXPECT_FALSE(gesture.is_made(60));
}

TEST(StaffGesture, IsNotMadeByACrowdOfHands) {
  input::StaffGesture gesture = two_corners();
  gesture.take(event(Kind::Down, 3, 0.5F, 0.5F), 2);
  EXPECT_FALSE(gesture.is_made(10));

  gesture.take(event(Kind::Up, 3, 0.5F, 0.5F), 11);
  EXPECT_FALSE(gesture.is_made(15.9)) << "the five seconds begin again";
  EXPECT_TRUE(gesture.is_made(16));
}

TEST(StaffGesture, IsNotMadeInCornersOfOneSide) {
  input::StaffGesture gesture;
  gesture.take(event(Kind::Down, 1, 0.02F, 0.05F), 0);
  gesture.take(event(Kind::Down, 2, 0.97F, 0.05F), 0);

  EXPECT_FALSE(gesture.is_made(60));
}

TEST(StaffGesture, EndsWithAFinger) {
  input::StaffGesture gesture = two_corners();
  gesture.take(event(Kind::Up, 2, 0.97F, 0.99F), 5);

  EXPECT_FALSE(gesture.is_made(60));
}

}  // namespace
}  // namespace docent::test::staff_gesture_test
