#include "runtime/motion/arm.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/runtime/motion/armed_figure.h"
#include "tests/runtime/motion/hand_made_graph.h"

namespace docent::motion::arm_test {
namespace {

float distance_to_ray(Vec3 point, Vec3 from, Vec3 through) {
  const Vec3 along = glm::normalize(through - from);
  return glm::length(glm::cross(point - from, along));
}

/// Where an arm can point without hurting: from the trunk, outwards positive.
Vec3 random_target(std::mt19937& chance, const JointPlace& trunk, Side side) {
  const auto between = [&](double a, double b) {
    return static_cast<float>(std::uniform_real_distribution(a, b)(chance));
  };
  const float azimuth = between(-0.35, 1.6), elevation = between(-0.9, 0.8);
  const float distance = between(1.0, 6.0);
  const Vec3 seen(sign_of(side) * std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                  std::cos(elevation) * std::cos(azimuth));
  return trunk.place + trunk.rotation * (distance * seen);
}

void expect_human(const test::MeasuredArm& arm) {
  EXPECT_LE(arm.elevation, arm_limits::elevation + 0.01F);
  const bool is_behind = arm.azimuth > arm_limits::outwards || arm.azimuth < -2.39F;
  const bool is_extended = is_behind && arm.elevation <= arm_limits::extension + 0.01F;
  if (arm.elevation > 0.5F && arm.elevation < 2.5F && !is_extended) {
    EXPECT_GE(arm.azimuth, -arm_limits::inwards - 0.01F);
    EXPECT_LE(arm.azimuth, arm_limits::outwards + 0.01F);
  }
  EXPECT_LE(arm.elbow, arm_limits::flexion + 0.01F);
  EXPECT_LE(arm.wrist, std::hypot(arm_limits::wrist_flexion, arm_limits::ulnar) + 0.01F);
}

class AnyFigure : public testing::TestWithParam<bool> {
 protected:
  test::ArmedFigure figure{GetParam() ? test::stretched_figure() : test::stick_figure()};
};
INSTANTIATE_TEST_SUITE_P(Arms, AnyFigure, testing::Bool());

TEST_P(AnyFigure, PointsWithArmAndHandWithinFiveCentimetresOfAThousandTargets) {
  std::mt19937 chance(17);
  float worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const Side side = both_sides[static_cast<std::size_t>(i % 2)];
    const JointPlace trunk = figure.trunk(side);
    const Vec3 target = random_target(chance, trunk, side);
    const Arm& arm = *figure.arms[side];

    const auto joints = figure.hold(side, pointing(figure.skeleton, arm, trunk, target));

    worst = std::max({worst, distance_to_ray(target, joints[arm.shoulder], joints.back()),
                      distance_to_ray(target, joints[arm.wrist], joints.back())});
    EXPECT_GT(glm::dot(joints.back() - joints[arm.wrist], target - joints[arm.wrist]), 0) << i;
  }
  EXPECT_LT(worst, 0.05F);
}

TEST_P(AnyFigure, HoldsWhatIsWithinReachBeforeTheBody) {
  for (const Side side : both_sides) {
    const Arm& arm = *figure.arms[side];
    const JointPlace trunk = figure.trunk(side);
    for (const float aside : {0.05F, 0.2F, 0.35F})
      for (const float ahead : {0.3F, 0.4F}) {
        const Vec3 out(sign_of(side), 0, 0);
        const Grip grip{trunk.place + trunk.rotation * (aside * out + Vec3(0, -0.15F, ahead)),
                        trunk.rotation * Vec3(0, 0.5F, 0.85F), trunk.rotation * -out};

        const ArmPosture posture = holding(figure.skeleton, arm, trunk, grip);

        EXPECT_LT(glm::distance(palm_of(figure.skeleton, arm, trunk, posture), grip.place), 0.01F);
        expect_human(test::measured(figure.hold(side, posture), arm, trunk));
      }
  }
}

TEST_P(AnyFigure, NeverHurtsAJointWhereverTheTargetIs) {
  std::mt19937 chance(18);
  std::uniform_real_distribution<float> anywhere(-4, 4);
  for (int i = 0; i < 2000; ++i) {
    const Side side = both_sides[static_cast<std::size_t>(i % 2)];
    const JointPlace trunk = figure.trunk(side);
    const Vec3 target = trunk.place + Vec3(anywhere(chance), anywhere(chance), anywhere(chance));
    const Arm& arm = *figure.arms[side];
    SCOPED_TRACE(i);
    for (const ArmPosture& posture :
         {pointing(figure.skeleton, arm, trunk, target),
          waving(figure.skeleton, arm, trunk, target, 0.01 * i), telling(0.01 * i)}) {
      expect_human(test::measured(figure.hold(side, posture), arm, trunk));
      const ArmPosture kept = within_limits(posture);
      EXPECT_EQ(kept.twist, posture.twist);
      EXPECT_EQ(kept.flexion, posture.flexion);
      EXPECT_EQ(kept.pronation, posture.pronation);
      EXPECT_EQ(kept.wrist_flexion, posture.wrist_flexion);
      EXPECT_EQ(kept.wrist_deviation, posture.wrist_deviation);
    }
  }
}

TEST_P(AnyFigure, WavesWithTheHandAboveTheShoulderAndThePalmTowardsWhoIsGreeted) {
  for (const Side side : both_sides) {
    const Arm& arm = *figure.arms[side];
    const JointPlace trunk = figure.trunk(side);
    for (const float aside : {0.0F, 0.7F, 1.4F}) {
      const Vec3 target = trunk.place + trunk.rotation * Vec3(3 * sign_of(side) * std::sin(aside),
                                                              0.5F, 3 * std::cos(aside));
      const auto joints = figure.hold(side, waving(figure.skeleton, arm, trunk, target, 1.0));
      EXPECT_GT(joints.back().y, joints[arm.shoulder].y + 0.2F);
      EXPECT_GT(joints[arm.wrist].y, joints[arm.elbow].y + 0.15F);
      const JointPlace wrist =
          place_of(figure.skeleton, static_cast<JointIndex>(arm.joint[arm.wrist]), figure.pose());
      // In a stretched-out arm the palm looks down.
      const Vec3 palm = wrist.rotation * (arm.rest[2] * Vec3(0, -1, 0));
      EXPECT_GT(glm::dot(palm, glm::normalize(target - wrist.place)), 0.6F);
    }
  }
}

TEST_P(AnyFigure, MovesBothArmsAsMirrorImages) {
  ArmPosture posture{.upper = glm::normalize(Vec3(0.6F, 0.1F, 0.7F)),
                     .twist = 0.4F,
                     .flexion = 0.9F,
                     .pronation = 0.5F,
                     .wrist_flexion = 0.2F,
                     .wrist_deviation = -0.3F,
                     .lift = 0.2F,
                     .reach = 0.1F};
  figure.rotation.assign(figure.rotation.size(), Quat(1, 0, 0, 0));
  const auto left = figure.hold(Side::Left, posture), right = figure.hold(Side::Right, posture);
  const float middle = figure.pose().root.x;
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_NEAR(left[i].x - middle, middle - right[i].x, 1e-4F);
    EXPECT_NEAR(left[i].y, right[i].y, 1e-4F);
    EXPECT_NEAR(left[i].z, right[i].z, 1e-4F);
  }
}

TEST(WithinLimits, BringsAnyPostureBackAndLeavesAHumanOneAlone) {
  EXPECT_TRUE(rc::check("whatever it is", [] {
    const auto any = [] { return static_cast<float>(*rc::gen::inRange(-500, 500)) / 100; };
    Vec3 upper(any(), any(), any());
    if (glm::length(upper) < 0.1F) upper = {0, -1, 0};
    const ArmPosture wild{.upper = glm::normalize(upper),
                          .twist = any(),
                          .flexion = any(),
                          .pronation = any(),
                          .wrist_flexion = any(),
                          .wrist_deviation = any(),
                          .lift = any(),
                          .reach = any()};
    const ArmPosture once = within_limits(wild), twice = within_limits(once);
    RC_ASSERT(glm::distance(once.upper, twice.upper) < 1e-4F);
    RC_ASSERT(once.twist == twice.twist && once.flexion == twice.flexion &&
              once.wrist_deviation == twice.wrist_deviation && once.lift == twice.lift);
    RC_ASSERT(once.flexion >= 0 && once.flexion <= arm_limits::flexion);
  }));
}

TEST(Arms, AreNoneWhereTheSkeletonHasNone) {
  Skeleton bare = test::stick_figure();
  for (const BodyPart part : {BodyPart::LeftElbow, BodyPart::RightShoulder})
    bare.part[static_cast<std::size_t>(part)] = JointIndex::None;

  const Arms arms = find_arms(bare);

  EXPECT_FALSE(arms[Side::Left]);
  EXPECT_FALSE(arms[Side::Right]);
}

}  // namespace
}  // namespace docent::motion::arm_test
