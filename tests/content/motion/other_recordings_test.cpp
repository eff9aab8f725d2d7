#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include <glm/gtx/quaternion.hpp>

#include "content/motion/compile_motion.h"
#include "content/motion/foot_plants.h"
#include "content/motion/joint_positions.h"
#include "content/motion/made_stands.h"
#include "content/motion/rest_pose.h"
#include "runtime/motion/walk.h"
#include "tests/content/motion/shipped_clips.h"
#include "tests/support/reference_data.h"
#include "tests/support/temporary_folder.h"

namespace docent::test::other_recordings_test {
namespace {

bool stands_or_stops(const motion::offline::SourceClip& source) {
  return source.clip.name == "stand-to-walk" || source.clip.name == "walk-to-stand";
}

TEST(Recordings, WithoutStartsAndStopsAreWalkedAllTheSame) {
  std::vector<motion::offline::SourceClip> clips = shipped_clips().clips;
  std::erase_if(clips, stands_or_stops);
  std::vector<Diagnostic> warnings;
  const MotionGraph graph =
      motion::offline::make_motion_graph(shipped_clips().skeleton, clips, "clips", {}, warnings);

  EXPECT_EQ(std::ranges::count(warnings, "made-clip", &Diagnostic::code), 4);
  const std::vector<Vec2> path{{0, 0}, {4, 0}, {6, 2}, {6, 6}};
  motion::WalkRequest request;
  request.path = path;
  const Result<motion::Walk> walk = motion::make_walk(graph, request);
  ASSERT_TRUE(walk.has_value()) << walk.error().what;
  EXPECT_GT(walk->transitions, 1U);
  EXPECT_LT(glm::distance(walk->body.front().position, path.front()), 0.02);
  EXPECT_LT(glm::distance(walk->body.back().position, path.back()), 0.02);
  EXPECT_LT(static_cast<double>(walk->root.size()) / walk->frame_rate, 14);
}

TEST(Recordings, OfAnotherRigAtThirtyFramesASecondAreWalkedMoreFinely) {
  const char* const name = "mocap/cmu-varied/bandai-namco-cc-by-nc/dataset-1_walk_normal_001.bvh";
  NEEDS_REFERENCE_DATA(name);
  const std::filesystem::path clip = reference_data() / name;
  const TemporaryFolder folder;
  std::filesystem::copy_file(clip, folder.path() / clip.filename());
  std::vector<Diagnostic> problems;
  const MotionGraph graph = motion::offline::compile_motion(folder.path(), {}, problems);

  EXPECT_EQ(graph.clips.front().frame_rate, 60);
  const std::vector<Vec2> path{{0, 0}, {8, 0}};
  motion::WalkRequest request;
  request.path = path;
  const Result<motion::Walk> walk = motion::make_walk(graph, request);
  ASSERT_TRUE(walk.has_value()) << walk.error().what;
  EXPECT_GT(walk->expanded, 0U);
  EXPECT_LT(glm::distance(walk->body.back().position, path.back()), 0.02);
}

TEST(Recordings, MayStandForLongAndLookLikeEachOtherThere) {
  MotionGraph graph = shipped_graph();
  graph.foresight = {};
  const auto clip_of = [&](ClipRole role) {
    return static_cast<std::uint32_t>(std::ranges::find(graph.clips, role, &MotionClip::role) -
                                      graph.clips.begin());
  };
  const std::uint32_t stop = clip_of(ClipRole::Stop);
  MotionClip& standing = graph.clips[stop];
  const std::vector<Quat> pose(standing.rotation.end() - standing.joint_count,
                               standing.rotation.end());
  for (int f = 0; f < 120; ++f) {
    standing.root.push_back(standing.root.back());
    standing.plants.push_back({true, true});
    standing.rotation.insert(standing.rotation.end(), pose.begin(), pose.end());
  }
  // From the end of the stand to the beginning of another.
  Transition again;
  again.from = {stop, frame_count(standing) - 30};
  again.to = {clip_of(ClipRole::Start), 20};
  again.radius = 10;
  const auto before = [](const Transition& t, const Transition& u) {
    return std::tuple(t.from.clip, t.from.frame) < std::tuple(u.from.clip, u.from.frame);
  };
  const auto place = std::ranges::upper_bound(graph.transitions, again, before);
  const auto index = static_cast<std::uint32_t>(place - graph.transitions.begin());
  graph.transitions.insert(place, again);
  for (MotionClass& motion_class : graph.classes)
    for (std::uint32_t& t : motion_class.transition) t += t >= index ? 1 : 0;

  const std::vector<Vec2> path{{0, 0}, {8, 0}};
  motion::WalkRequest request;
  request.path = path;
  const Result<motion::Walk> walk = motion::make_walk(graph, request);
  ASSERT_TRUE(walk.has_value()) << walk.error().what;
  EXPECT_GT(walk->expanded, 0U) << "it went by small steps";
}

TEST(MadeStands, StandAtOneEndWithBothFeetPlantedAndWalkAtTheOther) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  MotionClip walk = shipped_clips().named("walk");
  walk.role = ClipRole::Walk;
  walk.motion_class = "walk";
  motion::offline::find_foot_plants(skeleton, motion::offline::joint_positions(skeleton, walk),
                                    walk);
  const std::vector<MotionClip> made = motion::offline::made_stands(skeleton, {walk});

  ASSERT_EQ(made.size(), 4U);
  const auto speed = [](const MotionClip& clip, std::size_t from, std::size_t to) {
    return glm::distance(to_floor(clip.root[from]), to_floor(clip.root[to])) * clip.frame_rate /
           static_cast<double>(to - from);
  };
  for (const MotionClip& clip : made) {
    const std::size_t last = clip.root.size() - 1, some = last / 20;
    const bool starts = clip.role == ClipRole::Start;
    EXPECT_LT(starts ? speed(clip, 0, some) : speed(clip, last - some, last), 0.1) << clip.name;
    EXPECT_GT(starts ? speed(clip, last - some, last) : speed(clip, 0, some), 0.8) << clip.name;
    const FootPlants standing = clip.plants[starts ? 0 : last];
    EXPECT_TRUE(standing.left && standing.right) << clip.name;
  }
}

TEST(MadeStands, AreNoneWhereThereAreRecordedOnes) {
  std::vector<MotionClip> clips = shipped_graph().clips;
  EXPECT_TRUE(motion::offline::made_stands(shipped_clips().skeleton, clips).empty());
}

/// A rig whose bones all point along their own x axis while it has no rotation.
Skeleton rig_along_x(const Skeleton& skeleton, std::vector<MotionClip>& clips) {
  Skeleton rig = skeleton;
  std::vector<Quat> turn(skeleton.joint.size(), Quat(1, 0, 0, 0));
  for (std::size_t j = 0; j < rig.joint.size(); ++j) {
    const JointIndex parent = rig.joint[j].parent;
    if (parent == JointIndex::None) continue;
    Vec3& offset = rig.joint[j].offset;
    const std::size_t p = index_of(parent);
    if (glm::length(offset) < 1e-6F || turn[p] != Quat(1, 0, 0, 0)) continue;
    turn[p] = glm::rotation(glm::normalize(offset), Vec3(1, 0, 0));
  }
  for (Joint& joint : rig.joint)
    if (joint.parent != JointIndex::None)
      joint.offset = turn[index_of(joint.parent)] * joint.offset;
  for (MotionClip& clip : clips)
    for (std::size_t f = 0; f < clip.root.size(); ++f)
      for (std::size_t j = 0; j < rig.joint.size(); ++j) {
        const JointIndex parent = rig.joint[j].parent;
        Quat& local = clip.rotation[f * clip.joint_count + j];
        local = local * glm::inverse(turn[j]);
        if (parent != JointIndex::None) local = turn[index_of(parent)] * local;
      }
  return rig;
}

TEST(RestPose, IsFoundForARigThatDoesNotStandInItsOwnAndMovesNoJoint) {
  const Skeleton& skeleton = shipped_clips().skeleton;
  ASSERT_TRUE(motion::offline::stands_at_rest(skeleton));
  std::vector<MotionClip> clips{shipped_clips().named("walk"),
                                shipped_clips().named("turn-left-90")};
  const std::vector<MotionClip> as_recorded = clips;
  Skeleton rig = rig_along_x(skeleton, clips);
  ASSERT_FALSE(motion::offline::stands_at_rest(rig));

  std::vector<MotionClip*> rewritten;
  for (MotionClip& clip : clips) rewritten.push_back(&clip);
  motion::offline::rest_upright(rig, rewritten);

  EXPECT_TRUE(motion::offline::stands_at_rest(rig));
  for (std::size_t c = 0; c < clips.size(); ++c) {
    const motion::offline::JointPositions before = motion::offline::joint_positions(skeleton,
                                                                                    as_recorded[c]),
                                          after = motion::offline::joint_positions(rig, clips[c]);
    float most = 0;
    for (std::size_t i = 0; i < before.place.size(); ++i)
      most = std::max(most, glm::distance(before.place[i], after.place[i]));
    EXPECT_LT(most, 1e-3F);
  }
}

}  // namespace
}  // namespace docent::test::other_recordings_test
