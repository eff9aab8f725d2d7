#include "runtime/motion/pose.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "runtime/motion/leg.h"
#include "tests/runtime/motion/allocation_count.h"
#include "tests/runtime/motion/hand_made_graph.h"

namespace docent::motion {
namespace {

Walk two_frames() {
  Walk walk;
  walk.frame_rate = 10;
  walk.joint_count = 1;
  walk.root = {{0, 1, 0}, {1, 1, 0}};
  walk.rotation = {Quat(1, 0, 0, 0), glm::angleAxis(0.5f, Vec3(0, 1, 0))};
  return walk;
}

TEST(Sample, InterpolatesBetweenFrames) {
  const Walk walk = two_frames();
  std::vector<Quat> rotation(1);
  PoseView pose{{}, rotation};

  sample(walk, 0.05, pose);

  EXPECT_NEAR(pose.root.x, 0.5f, 1e-6f);
  EXPECT_NEAR(glm::angle(pose.rotation[0]), 0.25f, 1e-5f);
}

TEST(Sample, StaysAtTheEndsOutsideOfTheWalk) {
  const Walk walk = two_frames();
  std::vector<Quat> rotation(1);
  PoseView pose{{}, rotation};

  sample(walk, -3, pose);
  EXPECT_EQ(pose.root, walk.root.front());
  sample(walk, 1e9, pose);
  EXPECT_EQ(pose.root, walk.root.back());
  sample(walk, std::nan(""), pose);
  EXPECT_EQ(pose.root, walk.root.front());
}

TEST(ToWorldSpace, HangsEveryJointOnItsParent) {
  const Skeleton skeleton = test::stick_figure();
  std::vector<Quat> rotation(skeleton.joint.size(), Quat(1, 0, 0, 0));
  rotation[index_of(skeleton[BodyPart::LeftHip])] =
      glm::angleAxis(-static_cast<float>(M_PI_2), Vec3(1, 0, 0));  // thigh forwards
  std::vector<Mat4> world(skeleton.joint.size());

  to_world_space(skeleton, {{0, 1, 0}, rotation}, world);

  const Vec3 knee(world[index_of(skeleton[BodyPart::LeftKnee])][3]);
  EXPECT_NEAR(knee.z, 0.42f, 1e-5f);
  EXPECT_NEAR(knee.y, 0.98f + 0.01f, 1e-5f);
}

TEST(SkinningPalette, IsTheIdentityInTheBindPose) {
  const Skeleton skeleton = test::stick_figure();
  std::vector<Quat> rotation(skeleton.joint.size(), Quat(1, 0, 0, 0));
  std::vector<Mat4> world(rotation.size()), inverse_bind(rotation.size()), palette(rotation.size());
  to_world_space(skeleton, {{0, 1, 0}, rotation}, world);
  for (std::size_t j = 0; j < world.size(); ++j) inverse_bind[j] = glm::inverse(world[j]);

  fill_skinning_palette(world, inverse_bind, palette);

  for (const Mat4& matrix : palette)
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) EXPECT_NEAR(matrix[c][r], c == r ? 1 : 0, 1e-5f);
}

/// The hand-made stop clip's end: a figure that stands.
struct Standing {
  MotionGraph graph = test::hand_made_graph();
  std::vector<Quat> rotation = std::vector<Quat>(graph.skeleton.joint.size());
  PoseView pose{{}, rotation};

  void stand() { sample(graph.clips[2], 99, pose); }
};

TEST(Idle, AddsNothingAtFirst) {
  Standing figure;
  figure.stand();
  const std::vector<Quat> before = figure.rotation;
  const Vec3 root = figure.pose.root;

  add_idle(figure.graph.skeleton, 0, figure.pose);

  EXPECT_EQ(figure.pose.root, root);
  EXPECT_EQ(figure.rotation, before);
}

TEST(Idle, NeverFreezesAndNeverMovesAFoot) {
  Standing figure;
  const Legs legs = *find_legs(figure.graph.skeleton);
  figure.stand();
  const Foot left = foot_of(figure.graph.skeleton, legs[Side::Left], figure.pose);
  const Foot right = foot_of(figure.graph.skeleton, legs[Side::Right], figure.pose);
  Vec3 last = figure.pose.root;
  for (int frame = 1; frame < 60 * 60; ++frame) {
    figure.stand();
    const Vec3 standing = figure.pose.root;
    add_idle(figure.graph.skeleton, frame / 60.0, figure.pose);
    EXPECT_LT(
        glm::distance(foot_of(figure.graph.skeleton, legs[Side::Left], figure.pose).toe, left.toe),
        0.001f);
    EXPECT_LT(glm::distance(foot_of(figure.graph.skeleton, legs[Side::Right], figure.pose).toe,
                            right.toe),
              0.001f);
    EXPECT_LT(glm::distance(figure.pose.root, standing), 0.02f);
    EXPECT_LT(glm::distance(figure.pose.root, last), 0.0005f);  // 3 cm/s
    if (frame > 120) {
      EXPECT_GT(glm::distance(figure.pose.root, last), 0.0f);
    }
    last = figure.pose.root;
  }
}

TEST(TurnHead, TurnsTheHeadAboutTheVerticalHoweverTheBodyStands) {
  EXPECT_TRUE(rc::check("by the angle, and no limb moves", [] {
    const Skeleton skeleton = test::stick_figure();
    const auto angle = static_cast<float>(*rc::gen::inRange(-80, 81)) / 100;
    const auto lean = static_cast<float>(*rc::gen::inRange(-30, 31)) / 100;
    std::vector<Quat> rotation(skeleton.joint.size(), Quat(1, 0, 0, 0));
    rotation[0] = glm::angleAxis(lean, glm::normalize(Vec3(1, 0.5F, 0.3F)));
    std::vector<Mat4> before(skeleton.joint.size()), after(skeleton.joint.size());
    to_world_space(skeleton, {{0, 1, 0}, rotation}, before);

    PoseView pose{{0, 1, 0}, rotation};
    turn_head(skeleton, angle, pose);
    to_world_space(skeleton, pose, after);

    const std::size_t head = index_of(skeleton[BodyPart::Head]);
    const glm::mat3 turned =
        glm::mat3(glm::mat4_cast(glm::angleAxis(angle, Vec3(0, 1, 0)))) * glm::mat3(before[head]);
    for (int column = 0; column < 3; ++column)
      RC_ASSERT(glm::distance(turned[column], glm::mat3(after[head])[column]) < 1e-4F);
    for (const BodyPart part : {BodyPart::LeftAnkle, BodyPart::RightKnee, BodyPart::Hips}) {
      const std::size_t joint = index_of(skeleton[part]);
      RC_ASSERT(glm::distance(before[joint][3], after[joint][3]) < 1e-6F);
    }
  }));
}

TEST(FrameFunctions, DoNotAllocate) {
  const MotionGraph graph = test::hand_made_graph();
  const std::size_t joints = graph.skeleton.joint.size();
  std::vector<Quat> rotation(joints);
  std::vector<Mat4> world(joints), inverse_bind(joints, Mat4(1)), palette(joints);
  PoseView pose{{}, rotation};

  const long before = test::allocation_count();
  for (int frame = 0; frame < 600; ++frame) {
    sample(graph.clips[1], frame / 60.0, pose);
    add_idle(graph.skeleton, frame / 60.0, pose);
    turn_head(graph.skeleton, 0.3F, pose);
    to_world_space(graph.skeleton, pose, world);
    fill_skinning_palette(world, inverse_bind, palette);
  }
  const long during = test::allocation_count() - before;

  EXPECT_EQ(during, 0);
}

}  // namespace
}  // namespace docent::motion
