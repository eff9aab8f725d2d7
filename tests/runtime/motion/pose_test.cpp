#include "runtime/motion/pose.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <iterator>

#include "runtime/motion/gesture.h"
#include "runtime/motion/idle.h"
#include "runtime/motion/leg.h"
#include "tests/runtime/motion/allocation_count.h"
#include "tests/runtime/motion/hand_made_graph.h"

namespace docent::motion::pose_test {
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
  Limbs limbs = find_limbs(graph.skeleton);
  std::vector<Quat> rotation = std::vector<Quat>(graph.skeleton.joint.size());
  PoseView pose{{}, rotation};

  void stand() { sample(graph.clips[2], 99, pose); }
};

TEST(Idle, AddsNothingAtFirst) {
  Standing figure;
  figure.stand();
  const std::vector<Quat> before = figure.rotation;
  const Vec3 root = figure.pose.root;

  add_idle(figure.graph.skeleton, figure.limbs, {}, figure.pose);

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
    add_idle(figure.graph.skeleton, figure.limbs, {.seconds = frame / 60.0}, figure.pose);
    EXPECT_LT(
        glm::distance(foot_of(figure.graph.skeleton, legs[Side::Left], figure.pose).toe, left.toe),
        0.001f);
    EXPECT_LT(glm::distance(foot_of(figure.graph.skeleton, legs[Side::Right], figure.pose).toe,
                            right.toe),
              0.001f);
    EXPECT_LT(glm::distance(figure.pose.root, standing), 0.06f);
    EXPECT_LT(glm::distance(figure.pose.root, last), 0.0025f);  // 15 cm/s, in a shift of weight
    if (frame > 120) {
      EXPECT_GT(glm::distance(figure.pose.root, last), 0.0f);
    }
    last = figure.pose.root;
  }
}

/// The heights and turns that make a stand what it looks like.
std::vector<float> look_of(const Standing& figure) {
  std::vector<float> look{figure.pose.root.x, figure.pose.root.y, figure.pose.root.z};
  for (const Quat& q : figure.rotation) look.insert(look.end(), {q.x, q.y, q.z, q.w});
  return look;
}

TEST(Idle, NeverShowsTheSameTwentySecondsTwiceInAnHourNorThoseOfAnother) {
  constexpr int window = 20, windows = 3600 / window;
  const auto film = [](std::uint64_t who, int begin) {  // a picture a second
    Standing figure;
    std::vector<float> pictures;
    for (int second = 1; second <= window; ++second) {
      figure.stand();
      add_idle(figure.graph.skeleton, figure.limbs,
               {.seconds = begin + static_cast<double>(second), .who = who}, figure.pose);
      std::ranges::copy(look_of(figure), std::back_inserter(pictures));
    }
    return pictures;
  };
  const auto apart = [](const std::vector<float>& a, const std::vector<float>& b) {
    float most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
  };
  std::vector<std::vector<float>> films;
  for (int i = 0; i < windows; ++i) films.push_back(film(1, 4 + window * i));
  for (int i = 0; i < windows; ++i) films.push_back(film(2, 4 + window * i));

  float nearest = 1;
  for (std::size_t i = 0; i < films.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, apart(films[i], films[j]));

  EXPECT_GT(nearest, 0.02F);  // a centimetre and more, or degrees, somewhere
}

TEST(Idle, IsAsSmoothAndAsAliveAfterAMonthAsInTheFirstMinute) {
  Standing figure;
  const auto most_moved = [&](double begin) {
    float most = 0;
    std::vector<float> last;
    for (int frame = 0; frame < 60 * 60; ++frame) {
      figure.stand();
      add_idle(figure.graph.skeleton, figure.limbs, {.seconds = begin + frame / 60.0}, figure.pose);
      const std::vector<float> now = look_of(figure);
      for (std::size_t i = 0; i < last.size(); ++i)
        most = std::max(most, std::abs(now[i] - last[i]));
      last = now;
    }
    return most;
  };

  const float young = most_moved(10), old = most_moved(30 * 86400.0);

  EXPECT_GT(old, young / 2);
  EXPECT_LT(old, young * 2);
}

TEST(Gaze, ReachesItsWishWithinASecondAndNeverTurnsQuickerThanAHeadDoes) {
  for (const double dt : {1 / 240.0, 1 / 60.0, 1 / 15.0}) {
    Gaze gaze;
    double last = 0;
    for (double t = 0; t < 1.2; t += dt) {
      follow_gaze(1.4, 0.3, dt, gaze);
      EXPECT_LT(std::abs(gaze.yaw - last) / dt, 3.3);
      last = gaze.yaw;
    }
    EXPECT_NEAR(gaze.yaw, 1.4, 0.03);
    EXPECT_NEAR(gaze.pitch, 0.3, 0.01);
  }
}

TEST(Gaze, StaysWithinWhatANeckAllowsHoweverLongAFrameTakes) {
  Gaze gaze;
  for (const double dt : {0.0, 1e-3, 10.0, 1e6}) {
    follow_gaze(3, 2, dt, gaze);
    EXPECT_LE(std::abs(gaze.yaw), most_gaze_yaw);
    EXPECT_LE(gaze.pitch, most_gaze_up);
    EXPECT_TRUE(std::isfinite(gaze.yaw_rate));
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
    turn_head(skeleton, {.yaw = angle}, pose);
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
  const Limbs limbs = find_limbs(graph.skeleton);
  ArmMotion motion;
  ASSERT_TRUE(limbs.arms[Side::Left].has_value());

  const long before = test::allocation_count();
  for (int frame = 0; frame < 600; ++frame) {
    sample(graph.clips[1], frame / 60.0, pose);
    add_idle(graph.skeleton, limbs, {.seconds = frame / 60.0}, pose);
    turn_head(graph.skeleton, {.yaw = 0.3, .pitch = 0.2}, pose);
    const ArmOrder order{.gesture = static_cast<Gesture>(frame / 30 % 3), .target = {1, 1, 1}};
    move_arm(graph.skeleton, *limbs.arms[Side::Left], order, 1 / 60.0, motion, pose);
    to_world_space(graph.skeleton, pose, world);
    fill_skinning_palette(world, inverse_bind, palette);
  }
  const long during = test::allocation_count() - before;

  EXPECT_EQ(during, 0);
}

}  // namespace
}  // namespace docent::motion::pose_test
