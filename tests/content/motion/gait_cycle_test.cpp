#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "content/import/motion/bvh.h"
#include "content/motion/classify.h"
#include "content/motion/foot_plants.h"
#include "content/motion/gait_cycle.h"
#include "content/motion/resample.h"
#include "tests/content/motion/shipped_clips.h"
#include "tests/support/reference_data.h"

namespace docent::test::gait_cycle_test {
namespace {

std::string class_of(const Skeleton& skeleton, MotionClip clip) {
  const motion::offline::JointPositions track = motion::offline::joint_positions(skeleton, clip);
  motion::offline::find_foot_plants(skeleton, track, clip);
  return motion::offline::motion_class_of(motion::offline::measure_clip(skeleton, clip, track),
                                          motion::offline::size_of(skeleton));
}

std::vector<motion::offline::GaitCycle> cycles_of(const Skeleton& skeleton,
                                                  const MotionClip& clip) {
  return motion::offline::find_gait_cycles(skeleton, clip,
                                           motion::offline::joint_positions(skeleton, clip));
}

/// The recording played faster.
MotionClip faster(const MotionClip& clip, double times) {
  MotionClip fast = motion::offline::resample(clip, clip.frame_rate / times);
  fast.frame_rate = clip.frame_rate;
  return fast;
}

TEST(MotionClass, OfTheShippedClipsIsWalk) {
  for (const motion::offline::SourceClip& source : shipped_clips().clips)
    EXPECT_EQ(class_of(shipped_clips().skeleton, source.clip), "walk") << source.file;
}

TEST(MotionClass, OfAWalkPlayedFasterIsBrisk) {
  EXPECT_EQ(class_of(shipped_clips().skeleton, faster(shipped_clips().named("walk"), 1.35)),
            "brisk-walk");
}

TEST(MotionClass, OfWhoStandsIsOther) {
  MotionClip clip = shipped_clips().named("stand-to-walk");
  clip.root.resize(30);
  clip.rotation.resize(30 * static_cast<std::size_t>(clip.joint_count));

  EXPECT_EQ(class_of(shipped_clips().skeleton, clip), "other");
}

TEST(MotionClass, OfRecordingsIsWhatTheirNamesSay) {
  NEEDS_REFERENCE_DATA("mocap/cmu-varied");
  using Recording = std::pair<const char*, const char*>;
  for (const auto& [file, expected] : {Recording{"cmu-walk/16_15-walk-forward", "walk"},
                                       {"cmu-walk/16_31-stand-to-walk", "walk"},
                                       {"cmu-walk/16_33-walk-to-stand", "walk"},
                                       {"cmu-varied/49_01-walk", "walk"},
                                       {"cmu-varied/05_01-walk-turning", "walk"},
                                       {"cmu-varied/16_21-brisk-walk", "brisk-walk"},
                                       {"cmu-varied/16_24-brisk-veer-left", "brisk-walk"},
                                       {"cmu-varied/16_26-brisk-veer-right", "brisk-walk"},
                                       {"cmu-varied/16_27-brisk-turn-left-90", "brisk-walk"},
                                       {"cmu-varied/16_30-brisk-turn-right-90", "brisk-walk"},
                                       {"cmu-varied/02_03-jog", "jog"},
                                       {"cmu-varied/16_37-jog-veer-left", "jog"},
                                       {"cmu-varied/16_43-jog-turn-right-90", "jog"},
                                       {"cmu-varied/09_01-run", "run"},
                                       {"cmu-varied/16_55-run-from-walk", "run"},
                                       {"cmu-varied/17_03-stealthy-walk", "stealthy-walk"},
                                       {"cmu-varied/14_04-drink-gesture", "other"},
                                       {"cmu-varied/14_21-climb-3-steps", "other"},
                                       {"cmu-varied/09_12-navigate-forward-back-sideways", "other"},
                                       {"cmu-varied/127_31-crouch-under", "other"}}) {
    const import::RecordedMotion motion =
        import::read_bvh(reference_data() / "mocap" / (std::string(file) + ".bvh"), {});
    EXPECT_EQ(class_of(motion.skeleton, motion.clip), expected) << file;
  }
}

TEST(GaitCycle, IsAStrideOfUsualTimeAndLength) {
  const auto cycles = cycles_of(shipped_clips().skeleton, shipped_clips().named("walk"));

  ASSERT_GE(cycles.size(), 2U);
  for (const motion::offline::GaitCycle& cycle : cycles) {
    EXPECT_NEAR(cycle.seconds, 1.1, 0.2);
    EXPECT_NEAR(cycle.metres, 1.3, 0.35);
  }
}

TEST(GaitCycle, IsNotFoundWhereNobodyWalks) {
  MotionClip clip = shipped_clips().named("stand-to-walk");
  clip.root.resize(40);
  clip.rotation.resize(40 * static_cast<std::size_t>(clip.joint_count));

  EXPECT_TRUE(cycles_of(shipped_clips().skeleton, clip).empty());
}

TEST(Unlikeness, IsNoughtForTheSameGaitMovedTurnedAndScaled) {
  const motion::offline::GaitCycle cycle =
      cycles_of(shipped_clips().skeleton, shipped_clips().named("walk")).front();
  EXPECT_TRUE(rc::check([&] {
    motion::offline::GaitCycle other = cycle;
    const double turn = *rc::gen::inRange(-314, 314) / 100.0;
    const double scale = *rc::gen::inRange(50, 200) / 100.0;
    const auto c = static_cast<float>(scale * std::cos(turn)),
               s = static_cast<float>(scale * std::sin(turn));
    for (auto& pose : other.place)
      for (Vec3& p : pose)
        p = {c * p.x - s * p.y, s * p.x + c * p.y, static_cast<float>(scale) * p.z};

    RC_ASSERT(motion::offline::unlikeness(cycle, other) < 0.02);  // of 24 poses together
    RC_ASSERT(motion::offline::unlikeness(other, cycle) < 0.02 * scale);
  }));
}

TEST(Unlikeness, GrowsWithWhatIsChanged) {
  const motion::offline::GaitCycle cycle =
      cycles_of(shipped_clips().skeleton, shipped_clips().named("walk")).front();
  double before = 0;
  for (const float bent : {0.05f, 0.1f, 0.2f, 0.4f}) {
    motion::offline::GaitCycle other = cycle;
    for (auto& pose : other.place) pose[4].x += bent;

    EXPECT_GT(motion::offline::unlikeness(cycle, other), before);
    before = motion::offline::unlikeness(cycle, other);
  }
}

TEST(Unlikeness, IsLessWithinAClassThanBetweenClasses) {
  NEEDS_REFERENCE_DATA("mocap/cmu-varied");
  const auto gait = [](const char* file) {
    const import::RecordedMotion motion = import::read_bvh(reference_data() / "mocap" / file, {});
    const auto cycles = cycles_of(motion.skeleton, motion.clip);
    return cycles.at(motion::offline::basic_gait(cycles));
  };
  const motion::offline::GaitCycle walk = gait("cmu-walk/16_15-walk-forward.bvh");
  const motion::offline::GaitCycle other_walk = gait("cmu-walk/16_12-turn-left-45.bvh");
  const motion::offline::GaitCycle brisk = gait("cmu-varied/16_21-brisk-walk.bvh");
  const motion::offline::GaitCycle jog = gait("cmu-varied/16_37-jog-veer-left.bvh");
  const motion::offline::GaitCycle run = gait("cmu-varied/16_55-run-from-walk.bvh");

  EXPECT_LT(motion::offline::unlikeness(walk, other_walk),
            motion::offline::unlikeness(walk, brisk));
  EXPECT_LT(motion::offline::unlikeness(walk, brisk), motion::offline::unlikeness(walk, jog));
  EXPECT_LT(motion::offline::unlikeness(walk, jog), motion::offline::unlikeness(walk, run));
  EXPECT_LT(motion::offline::unlikeness(jog, run), motion::offline::unlikeness(brisk, run));
}

}  // namespace
}  // namespace docent::test::gait_cycle_test
