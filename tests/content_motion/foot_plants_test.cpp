#include "content/motion/foot_plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/content_motion/shipped_clips.h"

namespace docent::test {
namespace {

MotionClip planted(MotionClip clip) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  find_foot_plants(skeleton, make_track(skeleton, clip), clip);
  return clip;
}

double share(const MotionClip& clip, bool FootPlants::* foot) {
  return static_cast<double>(std::ranges::count(clip.plants, true, foot)) / frame_count(clip);
}

TEST(FootPlants, OfAWalkLastMoreThanHalfOfAStride) {
  const MotionClip clip = planted(shipped_clips().named("walk"));

  EXPECT_NEAR(share(clip, &FootPlants::left), 0.57, 0.09);
  EXPECT_NEAR(share(clip, &FootPlants::right), 0.57, 0.09);
}

TEST(FootPlants, HoldTheToeStill) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  const MotionClip clip = planted(shipped_clips().named("walk"));
  const Track track = make_track(skeleton, clip);
  const std::size_t toe = index_of(skeleton[BodyPart::LeftToe]);

  for (std::size_t f = 1; f < clip.plants.size(); ++f)
    if (clip.plants[f].left && clip.plants[f - 1].left) {
      EXPECT_LT(glm::distance(track.at(f, toe), track.at(f - 1, toe)) * 120, 1.0f) << f;
    }
}

TEST(FootPlants, DoNotFlicker) {
  const MotionClip clip = planted(shipped_clips().named("turn-left-90"));

  std::size_t begun = 0;
  for (std::size_t f = 1; f < clip.plants.size(); ++f)
    begun += clip.plants[f].left && !clip.plants[f - 1].left;
  EXPECT_GE(begun, 3U);
  EXPECT_LE(begun, 5U);  // 4.3 s of walking
}

TEST(FootPlants, OfAStandAreBothFeet) {
  const MotionClip clip = planted(shipped_clips().named("stand-to-walk"));

  EXPECT_TRUE(clip.plants.front().left && clip.plants.front().right);
}

TEST(Ground, IsTheSameForClipsWhoseFloorWasNot) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  std::vector<MotionClip> clips(3, planted(shipped_clips().named("walk")));
  for (Vec3& root : clips[1].root) root.y += 0.03f;
  std::vector<Track> tracks;
  for (const MotionClip& clip : clips) tracks.push_back(make_track(skeleton, clip));
  const double rest = planted_height(skeleton, tracks[0], clips[0]);

  level_ground(skeleton, clips, tracks);

  for (std::size_t c = 0; c < clips.size(); ++c) {
    EXPECT_NEAR(planted_height(skeleton, tracks[c], clips[c]), rest, 1e-5);
    EXPECT_NEAR(tracks[c].at(7, 0).y, clips[c].root[7].y, 1e-5);
  }
}

TEST(Ground, IsPutUnderFeetThatWereRecordedFarFromIt) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  std::vector<MotionClip> clips{planted(shipped_clips().named("walk"))};
  for (Vec3& root : clips[0].root) root.y -= 1;
  std::vector<Track> tracks{make_track(skeleton, clips[0])};

  level_ground(skeleton, clips, tracks);

  EXPECT_NEAR(planted_height(skeleton, tracks[0], clips[0]), 0.025, 0.01);
}

}  // namespace
}  // namespace docent::test
