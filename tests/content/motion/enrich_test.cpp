// Clips that are made of others: mirrored ones, and turns between turns.
#include "content/motion/enrich.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "content/content_error.h"
#include "content/motion/compile_motion.h"
#include "content/motion/extract_root_motion.h"
#include "content/motion/foot_plants.h"
#include "content/motion/mirror.h"
#include "content/motion/parametric_turns.h"
#include "tests/content/motion/shipped_clips.h"
#include "tests/support/reference_data.h"

namespace docent::test::enrich_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180;

const Skeleton& skeleton() {
  return shipped_graph().skeleton;
}

/// A clip of the shipped graph: with plants and a role.
const MotionClip& shipped(const std::string& name) {
  return *std::ranges::find(shipped_graph().clips, name, &MotionClip::name);
}

MotionClip mirrored(const MotionClip& clip) {
  return docent::motion::offline::mirrored(motion::offline::find_counterparts(skeleton(), "clips"),
                                           clip);
}

std::vector<double> headings(const MotionClip& clip) {
  std::vector<double> headings;
  const motion::offline::JointPositions track = motion::offline::joint_positions(skeleton(), clip);
  for (const Placement& body : motion::offline::extract_root_motion(skeleton(), clip, track))
    headings.push_back(body.heading);
  return headings;
}

double turned(const MotionClip& clip) {
  const std::vector<double> heading = headings(clip);
  return heading.back() - heading.front();
}

/// Metres a second by which planted toe joints slide over the floor, on average.
double slide(const MotionClip& clip) {
  const motion::offline::JointPositions track = motion::offline::joint_positions(skeleton(), clip);
  double metres = 0, frames = 0;
  for (const auto& [part, foot] : {std::pair{BodyPart::LeftToe, &FootPlants::left},
                                   std::pair{BodyPart::RightToe, &FootPlants::right}}) {
    const std::size_t toe = index_of(skeleton()[part]);
    for (std::size_t f = 1; f < clip.plants.size(); ++f) {
      if (!(clip.plants[f].*foot) || !(clip.plants[f - 1].*foot)) continue;
      metres += glm::distance(to_floor(track.at(f, toe)), to_floor(track.at(f - 1, toe)));
      ++frames;
    }
  }
  return metres / frames * clip.frame_rate;
}

struct Registered {
  const MotionClip &a, &b;
  motion::offline::Registration registration;
};

Registered registered(const std::string& name_a, const std::string& name_b) {
  const MotionClip &a = shipped(name_a), &b = shipped(name_b);
  const motion::offline::PoseCloud cloud_a =
      motion::offline::make_pose_cloud(skeleton(), motion::offline::joint_positions(skeleton(), a));
  const motion::offline::PoseCloud cloud_b =
      motion::offline::make_pose_cloud(skeleton(), motion::offline::joint_positions(skeleton(), b));
  const std::vector<double> heading_a = headings(a), heading_b = headings(b);
  return {a, b, motion::offline::register_clips({a, cloud_a, heading_a}, {b, cloud_b, heading_b})};
}

MotionClip blended(const Registered& pair, double share) {
  MotionClip clip =
      motion::offline::blend_clips(skeleton(), pair.a, pair.b, pair.registration, share);
  motion::offline::find_foot_plants(skeleton(), motion::offline::joint_positions(skeleton(), clip),
                                    clip);
  return clip;
}

TEST(AMirroredClip, IsTheClipAgainWhenMirroredTwice) {
  for (const MotionClip& clip : shipped_graph().clips) {
    const MotionClip again = mirrored(mirrored(clip));

    EXPECT_EQ(again.root, clip.root);
    EXPECT_EQ(again.rotation, clip.rotation);
    EXPECT_EQ(again.role, clip.role);
  }
}

TEST(AMirroredClip, TurnsRightByAsMuchAsItTurnedLeft) {
  const MotionClip& left = shipped("turn-left-90");

  const MotionClip right = mirrored(left);

  EXPECT_EQ(right.role, ClipRole::TurnRight);
  EXPECT_NEAR(turned(right), -turned(left), 0.1 * degree);
}

TEST(AMirroredClip, IsPlantedOnTheOtherFoot) {
  const MotionClip& clip = shipped("walk");

  const MotionClip image = mirrored(clip);

  for (std::size_t f = 0; f < clip.plants.size(); ++f) {
    EXPECT_EQ(image.plants[f].left, clip.plants[f].right);
    EXPECT_EQ(image.plants[f].right, clip.plants[f].left);
  }
}

TEST(AMirroredClip, HasEveryJointWhereAMirrorShowsTheOther) {
  const std::vector<std::size_t> counterpart =
      motion::offline::find_counterparts(skeleton(), "clips");
  const MotionClip& clip = shipped("walk");
  const motion::offline::JointPositions seen = motion::offline::joint_positions(skeleton(), clip);

  const motion::offline::JointPositions track =
      motion::offline::joint_positions(skeleton(), mirrored(clip));

  for (std::size_t f = 0; f < clip.root.size(); f += 20)
    for (std::size_t j = 0; j < counterpart.size(); ++j) {
      const Vec3 place = seen.at(f, counterpart[j]);
      EXPECT_LT(glm::distance(track.at(f, j), Vec3(-place.x, place.y, place.z)), 1e-4f);
    }
}

TEST(Counterparts, AreTheJointsOfTheOtherSideInRecordedSkeletons) {
  for (const char* folder : {"mocap/cmu-walk", "mocap/cmu-walk/asfamc"}) {
    NEEDS_REFERENCE_DATA(folder);
    std::vector<Diagnostic> problems;
    const Skeleton recorded =
        motion::offline::compile_motion(reference_data() / folder, {}, problems).skeleton;

    const std::vector<std::size_t> counterpart =
        motion::offline::find_counterparts(recorded, folder);

    using enum BodyPart;
    for (const auto& [left, right] :
         {std::pair{LeftToeTip, RightToeTip}, std::pair{LeftHandTip, RightHandTip},
          std::pair{LeftClavicle, RightClavicle}, std::pair{HeadTop, HeadTop}})
      EXPECT_EQ(counterpart[index_of(recorded[left])], index_of(recorded[right])) << folder;
  }
}

TEST(Counterparts, AreNotFoundWhereOneLegIsLonger) {
  Skeleton limping = skeleton();
  limping.joint[index_of(limping[BodyPart::LeftAnkle])].offset.y -= 0.1f;

  try {
    motion::offline::find_counterparts(limping, "clips");
    FAIL() << "no error";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, "no-mirror");
    EXPECT_EQ(error.file, "clips");
    EXPECT_THAT(error.what(), HasSubstr("left_ankle"));
  }
}

TEST(Counterparts, AreNotFoundWhereNamesDoNotSaySides) {
  Skeleton odd = skeleton();
  odd.joint[index_of(odd[BodyPart::RightElbow])].name = "hook";

  EXPECT_THROW(motion::offline::find_counterparts(odd, "clips"), content::ContentError);
}

TEST(RegisteredClips, OnlyGoForwardsAndNotTwiceAsFastAsEachOther) {
  const motion::offline::Registration way = registered("turn-left-45", "turn-left-90").registration;

  ASSERT_GT(way.a.size(), 120U);
  for (std::size_t k = 1; k < way.a.size(); ++k) {
    const double a = way.a[k] - way.a[k - 1], b = way.b[k] - way.b[k - 1];
    EXPECT_GT(a, 0);
    EXPECT_GT(b, 0);
    EXPECT_LE(std::max(a, b), 2.01 * std::min(a, b));
  }
}

TEST(RegisteredClips, StandOnTheSameFeet) {
  const Registered pair = registered("walk", "turn-left-45");
  const auto frame = [](double moment) { return static_cast<std::size_t>(std::lround(moment)); };

  std::size_t same = 0;
  for (std::size_t k = 0; k < pair.registration.a.size(); ++k) {
    const FootPlants a = pair.a.plants[frame(pair.registration.a[k])];
    const FootPlants b = pair.b.plants[frame(pair.registration.b[k])];
    same += a.left == b.left && a.right == b.right;
  }

  EXPECT_GT(static_cast<double>(same), 0.85 * static_cast<double>(pair.registration.a.size()));
}

TEST(ABlendedTurn, TurnsByAnAngleBetweenItsParentsThatGrowsWithTheShare) {
  const Registered pair = registered("turn-left-45", "turn-left-90");
  double before = turned(blended(pair, 0));

  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    const double angle = turned(blended(pair, share));
    EXPECT_GT(angle, before);
    before = angle;
  }
  const double middle = turned(blended(pair, 0.5));
  EXPECT_GT(middle, turned(pair.a) + 5 * degree);
  EXPECT_LT(middle, turned(pair.b) - 5 * degree);
}

TEST(ABlendedTurn, SlidesOnItsFeetByAtMostTwoCentimetresASecondMoreThanItsParents) {
  for (const auto& [a, b] :
       {std::pair{"turn-left-45", "turn-left-90"}, std::pair{"walk", "turn-left-45"},
        std::pair{"turn-right-90", "turn-right-45"}}) {
    const Registered pair = registered(a, b);

    EXPECT_LT(slide(blended(pair, 0.5)), std::max(slide(pair.a), slide(pair.b)) + 0.02) << a << b;
  }
}

TEST(AnEnrichedGraph, HasTheTurnsBetweenThoseThatAreShipped) {
  std::vector<Diagnostic> warnings;
  const ShippedClips& shipped = shipped_clips();

  const MotionGraph graph = motion::offline::make_motion_graph(
      shipped.skeleton, shipped.clips, "clips", {.enrichment = {.turns = true}}, warnings);

  std::vector<std::string> made;
  for (std::size_t c = shipped.clips.size(); c < graph.clips.size(); ++c)
    made.push_back(graph.clips[c].name);
  EXPECT_THAT(made, ElementsAre("turn-right 112 of corner-right-130 and turn-right-90",
                                "turn-right 68 of turn-right-90 and turn-right-45",
                                "turn-right 23 of turn-right-45 and walk",
                                "walk 23 of walk and turn-left-45",
                                "turn-left 69 of turn-left-45 and turn-left-90",
                                "turn-left 113 of turn-left-90 and corner-left-130"));
  EXPECT_TRUE(warnings.empty());
}

TEST(AnEnrichedGraph, StartsAndStopsWithEitherFoot) {
  std::vector<Diagnostic> warnings;
  const ShippedClips& shipped = shipped_clips();

  const MotionGraph graph = motion::offline::make_motion_graph(
      shipped.skeleton, shipped.clips, "clips", {.enrichment = {.mirrored = true}}, warnings);

  EXPECT_EQ(std::ranges::count(graph.clips, ClipRole::Start, &MotionClip::role), 2);
  EXPECT_EQ(std::ranges::count(graph.clips, ClipRole::Stop, &MotionClip::role), 2);
}

TEST(AnEnrichedGraph, IsNotMirroredWhereTheBodyIsNot) {
  ShippedClips limping = shipped_clips();
  limping.skeleton.joint[index_of(limping.skeleton[BodyPart::LeftAnkle])].offset.y -= 0.1f;
  std::vector<Diagnostic> warnings;

  const MotionGraph graph = motion::offline::make_motion_graph(
      limping.skeleton, limping.clips, "clips", {.enrichment = {.mirrored = true}}, warnings);

  EXPECT_LE(graph.clips.size(), limping.clips.size());
  EXPECT_THAT(warnings, Contains(AllOf(Field(&Diagnostic::code, "no-mirror"),
                                       Field(&Diagnostic::severity, Severity::Warning))));
}

}  // namespace
}  // namespace docent::test::enrich_test
