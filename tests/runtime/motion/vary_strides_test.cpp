#include "runtime/motion/vary_strides.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/motion/hand_made_graph.h"

namespace docent::motion::vary_strides_test {
namespace {

const MotionGraph& motion_graph() {
  static const MotionGraph graph = test::hand_made_graph();
  return graph;
}
/// Of clips that move all joints: what they do not move is not varied.
const WalkGraph& walk_graph() {
  static const WalkGraph graph = [] {
    WalkGraph made = *make_walk_graph(motion_graph());
    made.quickest.joint.assign(made.quickest.joint.size(), 2.0);
    return made;
  }();
  return graph;
}

/// Ten seconds of one pose: arms a little forward, elbows a little bent.
Draft still_pose() {
  Draft draft = empty_draft(walk_graph());
  const Skeleton& skeleton = motion_graph().skeleton;
  std::vector<Quat> pose(skeleton.joint.size(), Quat{1, 0, 0, 0});
  for (const BodyPart part :
       {BodyPart::LeftShoulder, BodyPart::RightShoulder, BodyPart::LeftElbow, BodyPart::RightElbow})
    pose[index_of(skeleton[part])] = glm::angleAxis(-0.4F, Vec3(1, 0, 0));
  for (int f = 0; f < 1200; ++f) {
    draft.walk.root.emplace_back(0, 1, 0);
    draft.walk.rotation.insert(draft.walk.rotation.end(), pose.begin(), pose.end());
  }
  return draft;
}

Quat joint_at(const Draft& draft, std::size_t frame, BodyPart part) {
  const std::size_t joint = index_of(motion_graph().skeleton[part]);
  return draft.walk.rotation[frame * draft.walk.joint_count + joint];
}

double apart(Quat a, Quat b) {
  return 2 * std::acos(std::min(1.0, std::abs(static_cast<double>(glm::dot(a, b)))));
}

TEST(VariedStrides, CarryTheArmsOtherwiseInEachStep) {
  Draft draft = still_pose();
  vary_strides(walk_graph(), {.seed = 3}, draft);

  const auto step = static_cast<std::size_t>(1 / steps_a_frame(walk_graph()));
  std::size_t same = 0;
  for (std::size_t f = 3 * step; f + 3 * step < 1200; f += step)
    if (apart(joint_at(draft, f, BodyPart::LeftShoulder),
              joint_at(draft, f + step, BodyPart::LeftShoulder)) < 0.005)
      ++same;
  EXPECT_LT(same, 3U);
}

TEST(VariedStrides, LeaveLegsAndHipsAlone) {
  Draft draft = still_pose();
  vary_strides(walk_graph(), {.seed = 3}, draft);

  for (const BodyPart part : {BodyPart::Hips, BodyPart::LeftHip, BodyPart::RightKnee})
    for (std::size_t f = 0; f < 1200; f += 40)
      EXPECT_EQ(joint_at(draft, f, part), Quat(1, 0, 0, 0)) << f;
}

TEST(VariedStrides, BeginAndEndAsWhoStands) {
  const Draft still = still_pose();
  Draft draft = still;
  vary_strides(walk_graph(), {.seed = 3}, draft);

  for (const std::size_t f : {0U, 1199U})
    EXPECT_LT(
        apart(joint_at(draft, f, BodyPart::LeftElbow), joint_at(still, f, BodyPart::LeftElbow)),
        1e-3);
}

TEST(VariedStrides, GoOnWhereTheWalkBeforeLeftThem) {
  Draft before = still_pose(), after = still_pose();
  constexpr std::size_t frame = 600;
  vary_strides(walk_graph(), {.seed = 3}, before);
  vary_strides(walk_graph(),
               {.seed = 3, .first_step = frame * steps_a_frame(walk_graph()), .first_share = 1},
               after);

  for (std::size_t f = 0; f < 300; f += 20)
    EXPECT_LT(apart(joint_at(before, frame + f, BodyPart::RightShoulder),
                    joint_at(after, f, BodyPart::RightShoulder)),
              1e-3)
        << f;
}

TEST(VariedStrides, AreOthersOnAnotherPath) {
  EXPECT_NE(seed_of(std::vector<Vec2>{{0, 0}, {4, 0}}), seed_of(std::vector<Vec2>{{0, 0}, {4, 1}}));
}

}  // namespace
}  // namespace docent::motion::vary_strides_test
