#include "runtime/motion/leg.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "tests/runtime/motion/hand_made_graph.h"

namespace docent::motion::leg_test {
namespace {

struct Figure {
  Skeleton skeleton = test::stick_figure();
  Legs legs = *find_legs(skeleton);
  std::vector<Quat> rotation = std::vector<Quat>(skeleton.joint.size(), Quat(1, 0, 0, 0));
  PoseView pose{{0, 0.84f, 0}, rotation};
};

Quat turned_about(Vec3 axis, double angle) {
  return glm::angleAxis(static_cast<float>(angle), glm::normalize(axis));
}

TEST(PlaceFoot, BendsTheKneeForwards) {
  Figure figure;
  Foot foot = foot_of(figure.skeleton, figure.legs[Side::Left], figure.pose);
  foot.toe.y += 0.2f;

  place_foot(figure.skeleton, figure.legs[Side::Left], foot, figure.pose);

  const Leg& leg = figure.legs[Side::Left];
  const LegPose at = leg_pose(figure.skeleton, leg, figure.pose);
  EXPECT_GT(at.position[leg.knee].z, 0.2f);  // the figure faces +z
  EXPECT_NEAR(at.position[leg.knee].x, at.position[leg.hip].x, 0.02f);
}

RC_GTEST_PROP(PlaceFoot, PutsTheFootExactlyWhereItIsWantedWithinReach, ()) {
  Figure figure;
  const auto share = [] { return *rc::gen::inRange(-1000, 1001) / 1000.0; };
  figure.pose.rotation[0] = turned_about({0, 1, 0}, 3 * share());
  const Side side = *rc::gen::element(Side::Left, Side::Right);
  const Leg& leg = figure.legs[side];
  Foot foot = foot_of(figure.skeleton, leg, figure.pose);
  foot.toe += Vec3(0.2 * share(), 0.2 + 0.1 * share(), 0.2 * share());
  foot.rotation = turned_about({share(), 2, share()}, 0.5 * share()) * foot.rotation;
  const Vec3 hip = leg_pose(figure.skeleton, leg, figure.pose).position[leg.hip];
  RC_PRE(glm::distance(hip, ankle_of(leg, foot)) < 0.99f * leg.length);

  place_foot(figure.skeleton, leg, foot, figure.pose);

  const Foot placed = foot_of(figure.skeleton, leg, figure.pose);
  RC_ASSERT(glm::distance(placed.toe, foot.toe) < 1e-4f);
  RC_ASSERT(std::abs(glm::dot(placed.rotation, foot.rotation)) > 1 - 1e-5f);
}

TEST(PlaceFoot, StretchesTheLegTowardsAFootThatIsTooFar) {
  Figure figure;
  const Leg& leg = figure.legs[Side::Right];
  Foot foot = foot_of(figure.skeleton, leg, figure.pose);
  foot.toe.z += 2;

  place_foot(figure.skeleton, leg, foot, figure.pose);

  const LegPose at = leg_pose(figure.skeleton, leg, figure.pose);
  EXPECT_NEAR(glm::distance(at.position[leg.hip], at.position[leg.ankle]), leg.length, 0.001f);
  EXPECT_GT(at.position[leg.ankle].z, 0.7f);
}

TEST(PlaceFoot, LeavesTheOtherLegAlone) {
  Figure figure;
  const Foot before = foot_of(figure.skeleton, figure.legs[Side::Right], figure.pose);
  Foot foot = foot_of(figure.skeleton, figure.legs[Side::Left], figure.pose);
  foot.toe.y += 0.1f;

  place_foot(figure.skeleton, figure.legs[Side::Left], foot, figure.pose);

  EXPECT_EQ(foot_of(figure.skeleton, figure.legs[Side::Right], figure.pose).toe, before.toe);
}

TEST(FindLegs, NeedsTwoWholeLegs) {
  Skeleton skeleton = test::stick_figure();
  skeleton.part[static_cast<std::size_t>(BodyPart::LeftToe)] = JointIndex::None;

  EXPECT_FALSE(find_legs(skeleton));
}

TEST(Facing, IsCounterClockwiseFromEast) {
  Figure figure;  // faces +z, which is south
  EXPECT_NEAR(facing(figure.skeleton, figure.legs, figure.pose), -std::numbers::pi / 2, 1e-6);

  figure.pose.rotation[0] = turned_about({0, 1, 0}, std::numbers::pi / 2);
  EXPECT_NEAR(facing(figure.skeleton, figure.legs, figure.pose), 0, 1e-6);
}

}  // namespace
}  // namespace docent::motion::leg_test
