#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <set>
#include <tuple>

#include "content/content_error.h"
#include "content/import/motion/bvh_write.h"
#include "content/motion/compile_motion.h"
#include "content/motion/foot_plants.h"
#include "content/motion/resample.h"
#include "tests/content/motion/shipped_clips.h"
#include "tests/support/reference_data.h"
#include "tests/support/temporary_folder.h"

namespace docent::test::make_motion_graph_test {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

auto key(const Transition& t) {
  return std::tuple(t.from.clip, t.from.frame, t.to.clip, t.to.frame);
}

bool same(const MotionGraph& a, const MotionGraph& b) {
  return std::ranges::equal(a.transitions, b.transitions, [](const auto& s, const auto& t) {
    return key(s) == key(t) && s.radius == t.radius && s.distance == t.distance &&
           s.alignment.heading == t.alignment.heading &&
           s.alignment.position == t.alignment.position;
  });
}

/// Every promise that MotionGraph makes to those who walk on it.
void expect_invariants(const MotionGraph& graph) {
  EXPECT_TRUE(std::ranges::is_sorted(graph.transitions, {}, key));
  for (const Transition& t : graph.transitions) {
    ASSERT_LT(t.from.clip, graph.clips.size());
    ASSERT_LT(t.to.clip, graph.clips.size());
    EXPECT_GE(t.radius, 1U);
    EXPECT_GE(t.from.frame, t.radius);
    EXPECT_GE(t.to.frame, t.radius);
    EXPECT_LT(t.from.frame + t.radius, frame_count(graph.clips[t.from.clip]));
    EXPECT_LT(t.to.frame + t.radius, frame_count(graph.clips[t.to.clip]));
  }
  for (const MotionClip& clip : graph.clips) {
    EXPECT_EQ(clip.plants.size(), clip.root.size());
    EXPECT_EQ(clip.rotation.size(), clip.root.size() * clip.joint_count);
    EXPECT_EQ(clip.joint_count, graph.skeleton.joint.size());
  }
}

/// Transitions that can follow one another, in a slow and obvious way: whoever has arrived at
/// `to + radius` may leave at any later `from - radius`.
bool can_follow(const Transition& first, const Transition& then) {
  return first.to.clip == then.from.clip &&
         first.to.frame + first.radius <= then.from.frame - then.radius;
}

/// All that can come at some time after `first`, itself included, or, backwards, all that it can
/// come after.
std::set<std::size_t> reached_from(const MotionGraph& graph, std::size_t first,
                                   bool backwards = false) {
  std::set<std::size_t> seen{first};
  std::vector<std::size_t> waiting{first};
  while (!waiting.empty()) {
    const Transition& t = graph.transitions[waiting.back()];
    waiting.pop_back();
    for (std::size_t next = 0; next < graph.transitions.size(); ++next) {
      const Transition& other = graph.transitions[next];
      if ((backwards ? can_follow(other, t) : can_follow(t, other)) && seen.insert(next).second)
        waiting.push_back(next);
    }
  }
  return seen;
}

bool stops(const MotionGraph& graph, const Transition& t) {
  return graph.clips[t.to.clip].role == ClipRole::Stop;
}

/// From wherever a start leads, every walk can go on, reach a stop, and reach (nearly) all others.
void expect_no_dead_end(const MotionGraph& graph) {
  const std::size_t enough = graph.transitions.size() * 9 / 10;
  std::size_t starts = 0;
  std::set<std::size_t> reach_enough;  // who reaches somebody who does
  for (std::size_t i = 0; i < graph.transitions.size(); ++i) {
    const Transition& t = graph.transitions[i];
    starts += graph.clips[t.from.clip].role == ClipRole::Start;
    const bool continues = std::ranges::any_of(
        graph.transitions, [&](const Transition& next) { return can_follow(t, next); });
    EXPECT_TRUE(continues || stops(graph, t)) << "transition " << i;
    if (!continues || reach_enough.contains(i)) continue;
    EXPECT_GT(reached_from(graph, i).size(), enough);
    reach_enough.merge(reached_from(graph, i, true));
  }
  EXPECT_GT(starts, 0U);
  EXPECT_TRUE(
      std::ranges::any_of(graph.transitions, [&](const Transition& t) { return stops(graph, t); }));
}

/// Lays a transition's destination onto its source by its alignment, and measures the hips' gap.
double gap_of(const MotionGraph& graph, const Transition& t) {
  const Vec2 from = to_floor(graph.clips[t.from.clip].root[t.from.frame]);
  const Vec2 to = to_floor(graph.clips[t.to.clip].root[t.to.frame]);
  const double c = std::cos(t.alignment.heading), s = std::sin(t.alignment.heading);
  return glm::distance(from, t.alignment.position + Vec2{c * to.x - s * to.y, s * to.x + c * to.y});
}

TEST(MotionGraph, OfTheShippedClipsHasNoDeadEnd) {
  expect_invariants(shipped_graph());
  expect_no_dead_end(shipped_graph());
  EXPECT_GT(shipped_graph().transitions.size(), 100U);
}

TEST(MotionGraph, LaysClipsOntoEachOther) {
  for (const Transition& t : shipped_graph().transitions)
    EXPECT_LT(gap_of(shipped_graph(), t), 0.08);
}

TEST(MotionGraph, HasBothDirectionsOfEveryMeetingThatCanBeWalked) {
  std::size_t both = 0;
  for (const Transition& t : shipped_graph().transitions)
    both += std::ranges::any_of(shipped_graph().transitions, [&](const Transition& other) {
      return key(other) == std::tuple(t.to.clip, t.to.frame, t.from.clip, t.from.frame);
    });
  EXPECT_GT(2 * both, shipped_graph().transitions.size());
}

TEST(MotionGraph, JoinsOnlyFramesOnTheSameFeet) {
  for (const Transition& t : shipped_graph().transitions) {
    const FootPlants from = shipped_graph().clips[t.from.clip].plants[t.from.frame];
    const FootPlants to = shipped_graph().clips[t.to.clip].plants[t.to.frame];
    EXPECT_TRUE(from.left == to.left && from.right == to.right);
  }
}

TEST(MotionGraph, IsTheSameForAnyNumberOfThreads) {
  const ShippedClips& shipped = shipped_clips();
  for (const unsigned jobs : {2U, 3U, 8U}) {
    std::vector<Diagnostic> warnings;
    EXPECT_TRUE(same(motion::offline::make_motion_graph(shipped.skeleton, shipped.clips, "clips",
                                                        {.jobs = jobs}, warnings),
                     shipped_graph()));
  }
}

TEST(MotionGraph, CanBeMadeAtOtherFrameRates) {
  for (const double rate : {60.0, 30.0}) {
    ShippedClips slower = shipped_clips();
    for (motion::offline::SourceClip& source : slower.clips)
      source.clip = motion::offline::resample(source.clip, rate);
    std::vector<Diagnostic> warnings;

    const MotionGraph graph =
        motion::offline::make_motion_graph(slower.skeleton, slower.clips, "clips", {}, warnings);

    expect_invariants(graph);
    expect_no_dead_end(graph);
    EXPECT_THAT(warnings, IsEmpty());
  }
}

TEST(MotionGraph, HasNoDeadEndWhereClipsAreMadeOfOthers) {
  const ShippedClips& shipped = shipped_clips();
  std::vector<Diagnostic> warnings;

  const MotionGraph graph = motion::offline::make_motion_graph(
      shipped.skeleton, shipped.clips, "clips", {.enrichment = {.mirrored = true, .turns = true}},
      warnings);

  expect_invariants(graph);
  expect_no_dead_end(graph);
  EXPECT_GT(graph.clips.size(), shipped.clips.size() + 4);
  EXPECT_THAT(warnings, IsEmpty());
}

TEST(MotionGraph, AvoidsAndReportsFaultsOfCapture) {
  ShippedClips faulty = shipped_clips();
  for (motion::offline::SourceClip& source : faulty.clips)
    if (source.clip.name == "walk")
      for (std::size_t f = 180; f <= 220; f += 4) source.clip.root[f].y += 0.7f;
  std::vector<Diagnostic> warnings;

  const MotionGraph graph =
      motion::offline::make_motion_graph(faulty.skeleton, faulty.clips, "clips", {}, warnings);

  EXPECT_THAT(warnings, Contains(Field(&Diagnostic::code, "capture-fault")));
  for (const Transition& t : graph.transitions)
    for (const ClipFrame& end : {t.from, t.to})
      if (graph.clips[end.clip].name == "walk") {
        EXPECT_GT(std::abs(static_cast<double>(end.frame) - 200.0), t.radius + 20);
      }
}

TEST(MotionGraph, MendsAndReportsAFrameThatLeaps) {
  ShippedClips faulty = shipped_clips();
  for (motion::offline::SourceClip& source : faulty.clips)
    if (source.clip.name == "walk") source.clip.root[200].y += 0.7f;
  std::vector<Diagnostic> warnings;

  const MotionGraph graph =
      motion::offline::make_motion_graph(faulty.skeleton, faulty.clips, "clips", {}, warnings);

  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].code, "mended-fault");
  EXPECT_THAT(warnings[0].file, HasSubstr("walk"));
  EXPECT_THAT(warnings[0].message, HasSubstr("cm in frames 199 to 201 and was mended"));
  for (std::size_t c = 0; c < graph.clips.size(); ++c)
    for (std::size_t f = 0; f < graph.clips[c].root.size(); ++f)
      EXPECT_LT(glm::distance(graph.clips[c].root[f], shipped_graph().clips[c].root[f]), 0.002f);
}

TEST(MotionGraph, WithoutAStartOrAStopIsAnError) {
  for (const char* missing : {"stand-to-walk", "walk-to-stand"}) {
    ShippedClips some = shipped_clips();
    // What is left is too short for one to be made of it.
    std::erase_if(some.clips, [&](const motion::offline::SourceClip& s) {
      return s.clip.name == missing || s.clip.role == ClipRole::Other;
    });
    for (motion::offline::SourceClip& source : some.clips) {
      source.clip.root.resize(std::min<std::size_t>(source.clip.root.size(), 100));
      source.clip.rotation.resize(source.clip.root.size() * source.clip.joint_count);
    }
    std::vector<Diagnostic> warnings;
    try {
      motion::offline::make_motion_graph(some.skeleton, some.clips, "clips", {}, warnings);
      FAIL() << "no error";
    } catch (const content::ContentError& error) {
      EXPECT_EQ(error.code, "no-walk");
      EXPECT_EQ(error.file, "clips");
      EXPECT_THAT(error.what(), HasSubstr("no clip st"));
    }
  }
}

void copy_clips(const TemporaryFolder& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(source_dir() / "content/clips"))
    if (entry.path().extension() == ".bvh")
      std::filesystem::copy_file(entry.path(), folder.path() / entry.path().filename());
}

TEST(MotionFolder, LeavesOutAnotherBodyAndBringsClipsToOneRate) {
  const TemporaryFolder folder;
  copy_clips(folder);
  const ShippedClips& shipped = shipped_clips();
  const MotionClip slow = motion::offline::resample(shipped.named("walk"), 60);
  import::write_bvh(shipped.skeleton, {60, slow.root, slow.rotation}, folder.path() / "walk.bvh");
  Skeleton taller = shipped.skeleton;
  for (Joint& joint : taller.joint) joint.offset *= 1.05f;
  import::write_bvh(taller, {60, slow.root, slow.rotation}, folder.path() / "zoe.bvh");
  std::vector<Diagnostic> problems;

  const MotionGraph graph = motion::offline::compile_motion(folder.path(), {}, problems);

  EXPECT_EQ(graph.clips.size(), 9U);
  for (const MotionClip& clip : graph.clips) EXPECT_EQ(clip.frame_rate, 120);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].code, "other-skeleton");
  EXPECT_THAT(problems[0].file, HasSubstr("zoe.bvh"));
}

TEST(MotionFolder, LeavesOutWhatDoesNotWalk) {
  const TemporaryFolder folder;
  copy_clips(folder);
  const ShippedClips& shipped = shipped_clips();
  const MotionClip& start = shipped.named("stand-to-walk");
  import::write_bvh(
      shipped.skeleton,
      {120, std::span(start.root).first(30),
       std::span(start.rotation).first(30 * static_cast<std::size_t>(start.joint_count))},
      folder.path() / "stand.bvh");
  std::vector<Diagnostic> problems;

  EXPECT_EQ(motion::offline::compile_motion(folder.path(), {}, problems).clips.size(), 9U);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].code, "not-walking");
}

TEST(MotionFolder, WithOneBrokenFileIsAnErrorThatNamesIt) {
  const TemporaryFolder folder;
  copy_clips(folder);
  std::filesystem::resize_file(folder.path() / "walk.bvh", 100'000);
  std::vector<Diagnostic> problems;

  try {
    motion::offline::compile_motion(folder.path(), {}, problems);
    FAIL() << "no error";
  } catch (const content::ContentError& error) {
    EXPECT_THAT(error.file, HasSubstr("walk.bvh"));
    EXPECT_GT(error.line, 0U);
  }
}

class RecordedClips : public testing::TestWithParam<const char*> {};

TEST_P(RecordedClips, MakeAGraphWithoutDeadEnds) {
  NEEDS_REFERENCE_DATA(GetParam());
  std::vector<Diagnostic> problems;
  const auto begin = std::chrono::steady_clock::now();

  const MotionGraph graph =
      motion::offline::compile_motion(reference_data() / GetParam(), {}, problems);

  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  RecordProperty("seconds", std::to_string(took.count()));
  RecordProperty("transitions", std::to_string(graph.transitions.size()));
  expect_invariants(graph);
  expect_no_dead_end(graph);
  std::vector<std::size_t> used(graph.clips.size());
  for (const Transition& t : graph.transitions) ++used[t.from.clip];
  EXPECT_GT(std::ranges::min(used), 0U);
}

INSTANTIATE_TEST_SUITE_P(Every, RecordedClips,
                         testing::Values("mocap/cmu-walk", "mocap/cmu-walk/second-takes",
                                         "mocap/cmu-walk/asfamc"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::erase_if(name, [](char c) { return !std::isalpha(c); });
                           return name;
                         });

TEST(RecordedClips, HaveTheHandMendedThatLeaps) {
  NEEDS_REFERENCE_DATA("mocap/cmu-walk");
  std::vector<Diagnostic> problems;

  const MotionGraph graph =
      motion::offline::compile_motion(reference_data() / "mocap/cmu-walk", {}, problems);

  EXPECT_THAT(problems, Contains(testing::AllOf(Field(&Diagnostic::code, "mended-fault"),
                                                Field(&Diagnostic::file, HasSubstr("16_15")),
                                                Field(&Diagnostic::message, HasSubstr("LeftHand")),
                                                Field(&Diagnostic::message, HasSubstr("93 cm")))));
  const auto clip = std::ranges::find(graph.clips, "16_15-walk-forward", &MotionClip::name);
  ASSERT_NE(clip, graph.clips.end());
  const motion::offline::JointPositions track =
      motion::offline::joint_positions(graph.skeleton, *clip);
  EXPECT_TRUE(motion::offline::find_capture_faults(graph.skeleton, *clip, track).empty());
}

}  // namespace
}  // namespace docent::test::make_motion_graph_test
