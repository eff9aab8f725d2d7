#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "content/motion/compile_motion.h"
#include "content/motion/find_transitions.h"
#include "content/motion/foot_plants.h"
#include "content/motion/motion_classes.h"
#include "content/motion/resample.h"
#include "runtime/motion/walk_graph.h"
#include "tests/content/motion/shipped_clips.h"
#include "tests/support/reference_data.h"

namespace docent::test::motion_classes_test {
namespace {

/// The shipped walk, played `times` as fast, as a clip of some class.
MotionClip played(double times, const char* motion_class) {
  const MotionClip& walk = shipped_clips().named("walk");
  MotionClip clip = motion::offline::resample(walk, walk.frame_rate / times);
  clip.frame_rate = walk.frame_rate;
  clip.motion_class = motion_class;
  return clip;
}

/// The walk with its knees bent all the while.
MotionClip crouched_walk() {
  MotionClip clip = played(1, "stealthy-walk");
  const Skeleton& skeleton = shipped_clips().skeleton;
  for (std::size_t f = 0; f < clip.root.size(); ++f)
    for (const BodyPart knee : {BodyPart::LeftKnee, BodyPart::RightKnee}) {
      Quat& q = clip.rotation[f * clip.joint_count + index_of(skeleton[knee])];
      q = q * glm::angleAxis(0.5f, Vec3{1, 0, 0});
    }
  return clip;
}

MotionClip standing() {
  MotionClip clip = shipped_clips().named("stand-to-walk");
  clip.motion_class = "other";
  clip.root.resize(40);
  clip.rotation.resize(40 * static_cast<std::size_t>(clip.joint_count));
  return clip;
}

TEST(MotionClasses, HaveSymmetricCoefficientsThatAreZeroForTheirOwn) {
  const std::vector<MotionClip> clips{played(1, "walk"), crouched_walk(), played(1.4, "brisk-walk"),
                                      standing(), played(1.1, "walk")};

  const auto classes = motion::offline::find_motion_classes(shipped_clips().skeleton, clips);

  ASSERT_EQ(classes.size(), 4U);
  EXPECT_EQ(classes[0].name, "walk");
  EXPECT_EQ(classes[3].name, "other");
  for (std::size_t i = 0; i < classes.size(); ++i) {
    ASSERT_EQ(classes[i].coefficient.size(), classes.size());
    EXPECT_EQ(classes[i].coefficient[i], 0.0f);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_EQ(classes[i].coefficient[j], classes[j].coefficient[i]);
      EXPECT_TRUE(std::isfinite(classes[i].coefficient[j]));
    }
  }
}

TEST(MotionClasses, AreMoreAlikeTheLessTheirGaitsDiffer) {
  const std::vector<MotionClip> clips{played(1, "walk"), crouched_walk(), played(1.4, "brisk-walk"),
                                      standing()};

  const auto of_walk =
      motion::offline::find_motion_classes(shipped_clips().skeleton, clips)[0].coefficient;

  EXPECT_LT(of_walk[2], of_walk[1]);  // The same poses, faster, and others.
  EXPECT_LT(of_walk[1], of_walk[3]);  // What has no stride is farthest.
}

TEST(MotionClasses, OfTheShippedClipsAreOne) {
  ASSERT_EQ(shipped_graph().classes.size(), 1U);
  EXPECT_EQ(shipped_graph().classes[0].name, "walk");
  EXPECT_EQ(shipped_graph().classes[0].coefficient, std::vector{0.0f});
}

TEST(AlikeThreshold, OfAClassDoesNotDependOnTheOthers) {
  std::vector<MotionClip> clips{played(1, "walk")};
  motion::offline::StudiedClips studied;
  const auto study = [&] {
    const motion::offline::JointPositions track =
        motion::offline::joint_positions(shipped_clips().skeleton, clips.back());
    studied.cloud.push_back(motion::offline::make_pose_cloud(shipped_clips().skeleton, track));
  };
  study();
  const std::vector<double> alone = motion::offline::alike_thresholds(clips, studied, {});
  clips.push_back(played(1.5, "brisk-walk"));
  study();

  const std::vector<double> both = motion::offline::alike_thresholds(clips, studied, {});

  EXPECT_EQ(both[0], alone[0]);
  EXPECT_GT(both[1], 1.2 * both[0]);
}

TEST(MotionGraphOfClasses, HoldsWhatWalksAndRunsAndStillWalksByDefault) {
  NEEDS_REFERENCE_DATA("mocap/cmu-varied");
  const std::vector<std::filesystem::path> folders{reference_data() / "mocap/cmu-walk",
                                                   reference_data() / "mocap/cmu-varied"};
  std::vector<Diagnostic> problems;

  const MotionGraph graph = motion::offline::compile_motion(folders, {}, problems);
  const motion::WalkGraph walking = motion::make_walk_graph(graph).value();

  const auto has = [&](const char* name) {
    return std::ranges::any_of(graph.classes, [&](const auto& c) { return c.name == name; });
  };
  EXPECT_TRUE(has("walk") && has("brisk-walk") && has("jog"));
  EXPECT_EQ(walking.scopes, graph.classes.size());
  for (const std::uint32_t c : walking.starts) EXPECT_EQ(graph.clips[c].motion_class, "walk");
  const motion::ClipPath& start = walking.clip[walking.starts.front()];
  EXPECT_TRUE(std::isfinite(start.to_stand[0][start.first]));
  for (std::size_t c = 0; c < graph.clips.size(); ++c)
    EXPECT_TRUE(std::ranges::any_of(graph.transitions, [&](const Transition& t) {
      return t.to.clip == c;
    })) << graph.clips[c].name;
}

}  // namespace
}  // namespace docent::test::motion_classes_test
