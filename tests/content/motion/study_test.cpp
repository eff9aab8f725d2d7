#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "content/motion/capture_faults.h"
#include "content/motion/classify.h"
#include "content/motion/extract_root_motion.h"
#include "content/motion/foot_plants.h"
#include "content/motion/joint_pops.h"
#include "content/motion/resample.h"
#include "tests/content/motion/shipped_clips.h"

namespace docent::test::study_test {
namespace {

ClipRole role_of(MotionClip clip) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  const motion::offline::JointPositions track = motion::offline::joint_positions(skeleton, clip);
  motion::offline::find_foot_plants(skeleton, track, clip);
  return motion::offline::classify(motion::offline::measure_clip(skeleton, clip, track),
                                   motion::offline::size_of(skeleton));
}

MotionClip played_backwards(MotionClip clip) {
  MotionClip back = clip;
  for (std::size_t f = 0; f < clip.root.size(); ++f) {
    const std::size_t from = clip.root.size() - 1 - f;
    back.root[f] = clip.root[from];
    for (std::size_t j = 0; j < clip.joint_count; ++j)
      back.rotation[f * clip.joint_count + j] = clip.rotation[from * clip.joint_count + j];
  }
  return back;
}

TEST(Roles, AreThoseOfTheMotionAndNotOfTheName) {
  EXPECT_EQ(role_of(shipped_clips().named("stand-to-walk")), ClipRole::Start);
  EXPECT_EQ(role_of(shipped_clips().named("walk-to-stand")), ClipRole::Stop);
  EXPECT_EQ(role_of(shipped_clips().named("walk")), ClipRole::Walk);
  for (const char* angle : {"45", "90"}) {
    EXPECT_EQ(role_of(shipped_clips().named(std::string("turn-left-") + angle)),
              ClipRole::TurnLeft);
    EXPECT_EQ(role_of(shipped_clips().named(std::string("turn-right-") + angle)),
              ClipRole::TurnRight);
  }
}

TEST(Roles, AreNoneForWalkingBackwards) {
  EXPECT_EQ(role_of(played_backwards(shipped_clips().named("walk"))), ClipRole::Other);
}

TEST(Roles, AreNoneForStandingThroughout) {
  MotionClip clip = shipped_clips().named("stand-to-walk");
  clip.root.resize(30);
  clip.rotation.resize(30 * static_cast<std::size_t>(clip.joint_count));

  EXPECT_EQ(role_of(clip), ClipRole::Other);
}

TEST(RootMotion, TurnsByWhatAClipTurns) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  const MotionClip& clip = shipped_clips().named("turn-right-90");

  const auto body = motion::offline::extract_root_motion(
      skeleton, clip, motion::offline::joint_positions(skeleton, clip));

  EXPECT_NEAR((body.back().heading - body.front().heading) * 180 / std::numbers::pi, -90, 8);
}

TEST(RootMotion, TakesTheSwayOutAndKeepsTheWay) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  MotionClip clip = shipped_clips().named("walk");
  const auto straight = motion::offline::extract_root_motion(
      skeleton, clip, motion::offline::joint_positions(skeleton, clip));
  constexpr double stride = 1.1, sway = 0.03;  // seconds; metres to each side
  for (std::size_t f = 0; f < clip.root.size(); ++f)
    clip.root[f].x += static_cast<float>(
        sway * std::sin(2 * std::numbers::pi * static_cast<double>(f) / 120 / stride));

  const auto body = motion::offline::extract_root_motion(
      skeleton, clip, motion::offline::joint_positions(skeleton, clip));

  for (std::size_t f = 66; f + 66 < body.size(); ++f)
    EXPECT_LT(glm::distance(body[f].position, straight[f].position), 0.3 * sway) << f;
}

TEST(CaptureFaults, AreFoundWhereAHandLeaps) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  MotionClip clip = shipped_clips().named("walk");
  const std::size_t shoulder = index_of(skeleton[BodyPart::LeftShoulder]);
  for (std::size_t f = 200; f < 203; ++f)
    clip.rotation[f * clip.joint_count + shoulder] =
        glm::angleAxis(1.5f, Vec3{0, 0, 1}) * clip.rotation[f * clip.joint_count + shoulder];

  const auto faults = motion::offline::find_capture_faults(
      skeleton, clip, motion::offline::joint_positions(skeleton, clip));

  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NEAR(faults[0].first, 200, 1);
  EXPECT_NEAR(faults[0].last, 202, 1);
  EXPECT_GT(faults[0].metres, 0.3);
  EXPECT_NE(motion::offline::describe(faults[0], skeleton).find("leaps by"), std::string::npos);
}

TEST(CaptureFaults, AreNotSeenInSoundMotion) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  for (const motion::offline::SourceClip& source : shipped_clips().clips)
    EXPECT_TRUE(motion::offline::find_capture_faults(
                    skeleton, source.clip, motion::offline::joint_positions(skeleton, source.clip))
                    .empty())
        << source.file;
}

/// Throws the left arm aside in some frames, alternately if so wanted.
void throw_arm(MotionClip& clip, std::size_t first, std::size_t last, std::size_t every = 1) {
  const std::size_t shoulder = index_of(shipped_clips().skeleton[BodyPart::LeftShoulder]);
  for (std::size_t f = first; f <= last; f += every)
    clip.rotation[f * clip.joint_count + shoulder] =
        glm::angleAxis(1.5f, Vec3{0, 0, 1}) * clip.rotation[f * clip.joint_count + shoulder];
}

/// The largest distance between the joints of two motions, in some frames; metres.
double farthest_apart(const motion::offline::JointPositions& a,
                      const motion::offline::JointPositions& b, std::size_t first,
                      std::size_t last) {
  double most = 0;
  for (std::size_t f = first; f <= last; ++f)
    for (std::size_t j = 0; j < a.joints; ++j)
      most = std::max<double>(most, glm::distance(a.at(f, j), b.at(f, j)));
  return most;
}

TEST(Mending, PutsAnArmBackThatLeapsForAFrame) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  const MotionClip sound = shipped_clips().named("walk");
  const motion::offline::JointPositions truth = motion::offline::joint_positions(skeleton, sound);
  const std::size_t end = sound.root.size() - 1;
  using Frames = std::pair<std::size_t, std::size_t>;
  for (const auto& [first, last] : {Frames{200, 200}, {200, 204}, {0, 0}, {end, end}}) {
    MotionClip clip = sound;
    throw_arm(clip, first, last);
    motion::offline::JointPositions track = motion::offline::joint_positions(skeleton, clip);
    ASSERT_GT(farthest_apart(track, truth, first, last), 0.3);

    const auto mended = motion::offline::mend_capture_faults(skeleton, clip, track);

    ASSERT_EQ(mended.size(), 1U) << first;
    EXPECT_GT(mended[0].metres, 0.3);
    EXPECT_LE(mended[0].first, first + 1);
    EXPECT_GE(mended[0].last + 1, last);
    EXPECT_TRUE(motion::offline::find_capture_faults(skeleton, clip, track).empty());
    EXPECT_LT(farthest_apart(track, truth, first, last), 0.02) << first;
    EXPECT_LT(farthest_apart(track, motion::offline::joint_positions(skeleton, clip), 0, end),
              1e-6);
  }
}

TEST(Mending, LeavesAllOtherFramesAndJointsAlone) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  const MotionClip sound = shipped_clips().named("walk");
  MotionClip clip = sound;
  throw_arm(clip, 200, 201);
  motion::offline::JointPositions track = motion::offline::joint_positions(skeleton, clip);

  motion::offline::mend_capture_faults(skeleton, clip, track);

  std::size_t changed = 0;
  for (std::size_t i = 0; i < clip.rotation.size(); ++i)
    if (clip.rotation[i] != sound.rotation[i]) {
      ++changed;
      const std::size_t frame = i / clip.joint_count;
      EXPECT_NEAR(static_cast<double>(frame), 200.5, 3);
    }
  EXPECT_GT(changed, 1U);
  EXPECT_LT(changed, 20U);
  EXPECT_EQ(clip.root, sound.root);
}

TEST(Mending, GivesUpOnAnArmThatIsShakenForLong) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  MotionClip clip = shipped_clips().named("walk");
  throw_arm(clip, 200, 260, 4);
  const MotionClip shaken = clip;
  motion::offline::JointPositions track = motion::offline::joint_positions(skeleton, clip);

  EXPECT_TRUE(motion::offline::mend_capture_faults(skeleton, clip, track).empty());

  EXPECT_EQ(clip.rotation, shaken.rotation);
  EXPECT_EQ(motion::offline::find_capture_faults(skeleton, clip, track).size(), 1U);
}

/// Turns a wrist about the forearm in some frames; nothing of the hand goes far.
void twist_wrist(MotionClip& clip, std::size_t first, std::size_t last) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  const std::size_t wrist = index_of(skeleton[BodyPart::RightWrist]);
  const Vec3 along =
      glm::normalize(skeleton.joint[index_of(skeleton[BodyPart::RightHandTip])].offset);
  for (std::size_t f = first; f <= last; ++f)
    clip.rotation[f * clip.joint_count + wrist] =
        clip.rotation[f * clip.joint_count + wrist] * glm::angleAxis(2.5f, along);
}

TEST(JointPops, AreMendedWhereAHandTwistsFasterThanAnyCan) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  const MotionClip sound = shipped_clips().named("walk");
  const std::size_t wrist = index_of(skeleton[BodyPart::RightWrist]);
  for (const auto& [first, last] : {std::pair{200, 200}, {200, 206}, {200, 222}}) {
    MotionClip clip = sound;
    twist_wrist(clip, first, last);
    const auto pops = motion::offline::find_joint_pops(skeleton, clip);
    ASSERT_FALSE(pops.empty());
    EXPECT_EQ(pops[0].joint, wrist);
    EXPECT_TRUE(motion::offline::find_capture_faults(
                    skeleton, clip, motion::offline::joint_positions(skeleton, clip))
                    .empty());

    EXPECT_EQ(motion::offline::mend_joint_pops(skeleton, clip).size(), pops.size()) << last;

    EXPECT_TRUE(motion::offline::find_joint_pops(skeleton, clip).empty()) << last;
    EXPECT_EQ(clip.root, sound.root);
    for (std::size_t i = 0; i < clip.rotation.size(); ++i)
      ASSERT_TRUE(i % clip.joint_count == wrist || clip.rotation[i] == sound.rotation[i]);
  }
}

TEST(JointPops, AreNoneInSoundMotion) {
  for (const motion::offline::SourceClip& source : shipped_clips().clips)
    EXPECT_TRUE(motion::offline::find_joint_pops(shipped_clips().skeleton, source.clip).empty())
        << source.file;
}

TEST(Mending, CalmsAHeadThatLeapsAndTakesAWhileToComeBack) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  MotionClip clip = shipped_clips().named("walk");
  const std::size_t neck = index_of(skeleton[BodyPart::Chest]),
                    head = index_of(skeleton[BodyPart::HeadTop]);
  const auto bend = [&](const motion::offline::JointPositions& track, std::size_t f) {
    return glm::length(track.at(f - 4, head) - 2.0f * track.at(f, head) + track.at(f + 4, head));
  };
  const auto sound = motion::offline::joint_positions(skeleton, clip);
  for (std::size_t f = 200; f < 210; ++f)
    clip.rotation[f * clip.joint_count + neck] *=
        glm::angleAxis(0.007f * static_cast<float>(210 - f), Vec3(0, 0, 1));
  auto track = motion::offline::joint_positions(skeleton, clip);
  EXPECT_GT(bend(track, 200), 0.025f);

  const auto mended = motion::offline::mend_capture_faults(skeleton, clip, track);

  EXPECT_EQ(mended.size(), 1U);
  for (std::size_t f = 190; f < 220; ++f) EXPECT_LT(bend(track, f), 0.025f) << f;
  EXPECT_LT(glm::distance(track.at(205, head), sound.at(205, head)), 0.02f);
}

TEST(Mending, DoesNothingToSoundMotion) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  for (const motion::offline::SourceClip& source : shipped_clips().clips) {
    MotionClip clip = source.clip;
    motion::offline::JointPositions track = motion::offline::joint_positions(skeleton, clip);

    EXPECT_TRUE(motion::offline::mend_capture_faults(skeleton, clip, track).empty()) << source.file;
    EXPECT_EQ(clip.rotation, source.clip.rotation);
  }
}

TEST(Resampling, KeepsTheMotionAndItsLength) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  const MotionClip& clip = shipped_clips().named("walk");
  const MotionClip sparse = motion::offline::resample(clip, 60);

  const MotionClip dense = motion::offline::resample(sparse, 120);

  EXPECT_NEAR(frame_count(sparse), frame_count(clip) / 2.0, 1);
  const motion::offline::JointPositions expected = motion::offline::joint_positions(skeleton, clip),
                                        track = motion::offline::joint_positions(skeleton, dense);
  double worst = 0;
  for (std::size_t f = 8; f + 8 < dense.root.size(); ++f)
    for (std::size_t j = 0; j < track.joints; ++j)
      worst = std::max<double>(worst, glm::distance(track.at(f, j), expected.at(f, j)));
  EXPECT_LT(worst, 0.008);  // where a knee straightens within one frame
}

}  // namespace
}  // namespace docent::test::study_test
