#include "content/motion/foot_plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/content/motion/shipped_clips.h"

namespace docent::test::foot_plants_test {
namespace {

MotionClip planted(MotionClip clip) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  motion::offline::find_foot_plants(skeleton, motion::offline::joint_positions(skeleton, clip),
                                    clip);
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
  const motion::offline::JointPositions track = motion::offline::joint_positions(skeleton, clip);
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

double planted_height_of(const MotionClip& clip) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  return motion::offline::planted_height(skeleton, motion::offline::joint_positions(skeleton, clip),
                                         clip);
}

void level(std::vector<MotionClip>& clips) {
  std::vector<double> heights;
  for (const MotionClip& clip : clips) heights.push_back(planted_height_of(clip));
  const double rest = motion::offline::rest_height(shipped_clips().skeleton, heights);
  for (std::size_t c = 0; c < clips.size(); ++c)
    motion::offline::level_ground(rest - heights[c], clips[c]);
}

TEST(Ground, IsTheSameForClipsWhoseFloorWasNot) {
  std::vector<MotionClip> clips(3, planted(shipped_clips().named("walk")));
  for (Vec3& root : clips[1].root) root.y += 0.03f;
  const double rest = planted_height_of(clips[0]);

  level(clips);

  for (const MotionClip& clip : clips) EXPECT_NEAR(planted_height_of(clip), rest, 1e-5);
}

TEST(Ground, IsPutUnderFeetThatWereRecordedFarFromIt) {
  std::vector<MotionClip> clips{planted(shipped_clips().named("walk"))};
  for (Vec3& root : clips[0].root) root.y -= 1;

  level(clips);

  EXPECT_NEAR(planted_height_of(clips[0]), 0.025, 0.01);
}

}  // namespace
}  // namespace docent::test::foot_plants_test
