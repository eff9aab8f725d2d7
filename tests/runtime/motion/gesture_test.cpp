#include "runtime/motion/gesture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/runtime/motion/armed_figure.h"
#include "tests/runtime/motion/hand_made_graph.h"

namespace docent::motion::gesture_test {
namespace {

constexpr double frame = 1.0 / 60;

/// An arm that swings as in a walk, and gestures over that.
class GesturingArm {
 public:
  /// One frame; returns where the fingers' tips are, seen from the trunk.
  Vec3 step(const ArmOrder& order, double seconds = frame) {
    time_ += seconds;
    std::ranges::fill(figure_.rotation, Quat(1, 0, 0, 0));
    const Arm& arm = *figure_.arms[Side::Left];
    figure_.rotation[arm.joint[arm.shoulder]] =
        glm::angleAxis(1.4F, Vec3(0, 0, -1)) *
        glm::angleAxis(0.35F * static_cast<float>(std::sin(5.5 * time_)), Vec3(0, 1, 0));
    PoseView pose = figure_.pose();
    move_arm(figure_.skeleton, arm, order, seconds, motion_, pose);
    const JointPlace wrist =
        place_of(figure_.skeleton, static_cast<JointIndex>(arm.joint[arm.wrist]), pose);
    return wrist.place + wrist.rotation * (arm.rest[2] * Vec3(arm.hand, 0, 0));
  }
  Vec3 shoulder() { return figure_.trunk(Side::Left).place + Vec3(0.17F, 0.14F, 0); }

 private:
  test::ArmedFigure figure_{test::stretched_figure()};
  ArmMotion motion_;
  double time_ = 0;
};

constexpr Vec3 ahead{2, 1.6F, 1};

TEST(Gesture, LeavesAnArmThatDoesNothingElseToTheWalk) {
  GesturingArm idle, gesturing;
  for (int i = 0; i < 30; ++i) {
    idle.step({});
    gesturing.step({Gesture::Wave, ahead, i * frame});
  }
  for (int i = 0; i < 120; ++i) {
    idle.step({});
    gesturing.step({});
  }
  EXPECT_LT(glm::distance(idle.step({}), gesturing.step({})), 1e-5F);
}

TEST(Gesture, LiftsTheHandAboveTheShoulderWithinSevenTenthsOfASecond) {
  GesturingArm arm;
  Vec3 hand{};
  for (int i = 0; i < 42; ++i) hand = arm.step({Gesture::Wave, ahead, i * frame});
  EXPECT_GT(hand.y, arm.shoulder().y + 0.1F);
}

TEST(Gesture, MovesTheHandWithoutAJumpHoweverItIsCutShort) {
  std::mt19937 chance(17);
  GesturingArm arm;
  Vec3 last = arm.step({}), velocity{};
  ArmOrder order;
  float fastest = 0, hardest = 0;
  for (int i = 0, left = 0; i < 60 * 600; ++i, --left) {
    if (left <= 0) {
      left = std::uniform_int_distribution(1, 90)(chance);
      order = {static_cast<Gesture>(std::uniform_int_distribution(0, 3)(chance)),
               Vec3(std::uniform_real_distribution<float>(-1, 3)(chance), 1.4F, 2), 0};
    }
    order.seconds += frame;
    const Vec3 now = arm.step(order);
    const Vec3 moves = (now - last) / static_cast<float>(frame);
    fastest = std::max(fastest, glm::length(moves));
    if (i > 0) hardest = std::max(hardest, glm::length(moves - velocity));
    last = now;
    velocity = moves;
  }
  EXPECT_LT(fastest, 5.8F);  // metres a second: a hand thrown up in a hurry, over and over
  EXPECT_LT(hardest, 1.2F);  // of it within one frame
}

TEST(Gesture, EndsTheSameHoweverLongTheFramesTake) {
  GesturingArm even, uneven;
  for (int i = 0; i < 300; ++i) even.step({Gesture::Point, ahead, i * frame});
  double time = 0;
  for (const double dt : {0.0, 0.5, 2.0, 0.001, 2.5})
    uneven.step({Gesture::Point, ahead, time += dt}, dt);
  EXPECT_LT(
      glm::distance(even.step({Gesture::Point, ahead, 5}), uneven.step({Gesture::Point, ahead, 5})),
      1e-3F);
}

}  // namespace
}  // namespace docent::motion::gesture_test
