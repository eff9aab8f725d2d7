#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "content/motion/capture_faults.h"
#include "content/motion/classify.h"
#include "content/motion/extract_root_motion.h"
#include "content/motion/foot_plants.h"
#include "content/motion/resample.h"
#include "tests/content_motion/shipped_clips.h"

namespace docent::test {
namespace {

ClipRole role_of(MotionClip clip) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  const Track track = make_track(skeleton, clip);
  find_foot_plants(skeleton, track, clip);
  return classify(measure_clip(skeleton, clip, track), size_of(skeleton));
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

  const auto body = extract_root_motion(skeleton, clip, make_track(skeleton, clip));

  EXPECT_NEAR((body.back().heading - body.front().heading) * 180 / std::numbers::pi, -90, 8);
}

TEST(RootMotion, TakesTheSwayOutAndKeepsTheWay) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  MotionClip clip = shipped_clips().named("walk");
  const auto straight = extract_root_motion(skeleton, clip, make_track(skeleton, clip));
  constexpr double stride = 1.1, sway = 0.03;  // seconds; metres to each side
  for (std::size_t f = 0; f < clip.root.size(); ++f)
    clip.root[f].x += static_cast<float>(
        sway * std::sin(2 * std::numbers::pi * static_cast<double>(f) / 120 / stride));

  const auto body = extract_root_motion(skeleton, clip, make_track(skeleton, clip));

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

  const auto faults = find_capture_faults(skeleton, clip, make_track(skeleton, clip));

  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NEAR(faults[0].first, 200, 1);
  EXPECT_NEAR(faults[0].last, 202, 1);
  EXPECT_GT(faults[0].metres, 0.3);
  EXPECT_NE(describe(faults[0], skeleton).find("leaps by"), std::string::npos);
}

TEST(CaptureFaults, AreNotSeenInSoundMotion) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  for (const SourceClip& source : shipped_clips().clips)
    EXPECT_TRUE(
        find_capture_faults(skeleton, source.clip, make_track(skeleton, source.clip)).empty())
        << source.file;
}

TEST(Resampling, KeepsTheMotionAndItsLength) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  const MotionClip& clip = shipped_clips().named("walk");
  const MotionClip sparse = resample(clip, 60);

  const MotionClip dense = resample(sparse, 120);

  EXPECT_NEAR(frame_count(sparse), frame_count(clip) / 2.0, 1);
  const Track expected = make_track(skeleton, clip), track = make_track(skeleton, dense);
  double worst = 0;
  for (std::size_t f = 8; f + 8 < dense.root.size(); ++f)
    for (std::size_t j = 0; j < track.joints; ++j)
      worst = std::max<double>(worst, glm::distance(track.at(f, j), expected.at(f, j)));
  EXPECT_LT(worst, 0.008);  // where a knee straightens within one frame
}

}  // namespace
}  // namespace docent::test
