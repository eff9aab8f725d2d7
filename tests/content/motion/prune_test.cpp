#include "content/motion/prune.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace docent::test::prune_test {
namespace {

MotionClip clip_of(std::uint32_t frames, ClipRole role) {
  MotionClip clip;
  clip.role = role;
  clip.root.resize(frames);
  return clip;
}

Transition passage(ClipFrame from, ClipFrame to) {
  return {.from = from, .to = to, .radius = 5, .distance = 0.01f, .alignment = {}};
}

bool has(const MotionGraph& graph, ClipFrame from, ClipFrame to) {
  return std::ranges::any_of(graph.transitions, [&](const Transition& t) {
    return t.from.clip == from.clip && t.from.frame == from.frame && t.to.clip == to.clip &&
           t.to.frame == to.frame;
  });
}

constexpr std::uint32_t start = 0, walk = 1, stop = 2, stray = 3;

/// start -> walk, a loop in walk, walk -> stop, and ways that end nowhere.
MotionGraph small_graph() {
  MotionGraph graph;
  graph.clips = {clip_of(60, ClipRole::Start), clip_of(200, ClipRole::Walk),
                 clip_of(60, ClipRole::Stop), clip_of(100, ClipRole::Walk)};
  graph.transitions = {
      passage({start, 40}, {walk, 20}),  // leads in
      passage({walk, 100}, {walk, 20}),  // the loop
      passage({walk, 50}, {stop, 20}),   // leads out
      passage({walk, 60}, {walk, 150}),  // past the last exit: a dead end
      passage({walk, 30}, {stray, 50}),  // no way back
      passage({stray, 20}, {walk, 20}),  // nothing leads there
  };
  return graph;
}

TEST(Pruning, KeepsTheLoopAndWhatLeadsInFromAStartAndOutToAStop) {
  MotionGraph graph = small_graph();

  const motion::offline::Pruning pruning = motion::offline::prune(graph);

  EXPECT_TRUE(has(graph, {start, 40}, {walk, 20}));
  EXPECT_TRUE(has(graph, {walk, 100}, {walk, 20}));
  EXPECT_TRUE(has(graph, {walk, 50}, {stop, 20}));
  EXPECT_EQ(graph.transitions.size(), 3U);
  EXPECT_EQ(pruning.transitions_dropped, 3U);
  EXPECT_EQ(pruning.clips_outside, std::vector<std::size_t>{stray});
}

TEST(Pruning, DropsATransitionThatArrivesTooLateForTheNext) {
  MotionGraph graph = small_graph();
  // Arrives at 92 + 5, but the loop's blend begins at 100 - 5.
  graph.transitions.push_back(passage({walk, 40}, {walk, 92}));

  motion::offline::prune(graph);

  EXPECT_FALSE(has(graph, {walk, 40}, {walk, 92}));
}

TEST(Pruning, LeavesNothingOfAGraphWithoutALoopOrAStart) {
  MotionGraph graph = small_graph();
  graph.clips[start].role = ClipRole::Walk;
  graph.transitions = {passage({walk, 60}, {stray, 50})};

  motion::offline::prune(graph);

  EXPECT_TRUE(graph.transitions.empty());
}

TEST(OwnGraph, OfAClassHoldsWhatGoesOnWithoutTheOthers) {
  MotionGraph graph = small_graph();
  graph.clips[stray].motion_class = "jog";
  graph.transitions.push_back(passage({stray, 80}, {stray, 20}));  // a jog of its own
  graph.transitions.push_back(passage({walk, 160}, {walk, 20}));   // joins the dead end to the loop

  EXPECT_EQ(motion::offline::own_graph(graph, ""), (std::vector<std::uint32_t>{0, 1, 2, 3, 7}));
  EXPECT_EQ(motion::offline::own_graph(graph, "jog"), std::vector<std::uint32_t>{6});
  EXPECT_TRUE(motion::offline::own_graph(graph, "run").empty());
}

TEST(OwnGraph, LeavesOutWhatCanOnlyBeLeftByAnotherClass) {
  MotionGraph graph = small_graph();
  graph.clips[stray].motion_class = "jog";
  graph.transitions.push_back(passage({walk, 160}, {stray, 10}));  // the only way on after 150

  EXPECT_EQ(motion::offline::own_graph(graph, ""), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Pruning, OfAnEmptyGraphIsNothing) {
  MotionGraph graph;

  EXPECT_EQ(motion::offline::prune(graph).transitions_dropped, 0U);
}

}  // namespace
}  // namespace docent::test::prune_test
