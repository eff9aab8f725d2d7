#include <gtest/gtest.h>

#include <numbers>

#include "content/motion/compile_motion.h"
#include "runtime/motion/walk.h"
#include "runtime/motion/walk_graph.h"
#include "tests/runtime/motion/walk_measures.h"
#include "tests/support/reference_data.h"

namespace docent::motion::recorded_walk_test {
namespace {

const MotionGraph& recorded_graph() {
  static const MotionGraph graph = [] {
    std::vector<Diagnostic> problems;
    return motion::offline::compile_motion(test::reference_data() / "mocap/cmu-walk", {}, problems);
  }();
  return graph;
}

/// 33 m of the ellipse that the founding paper walks along.
std::vector<Vec2> elliptic_arc() {
  std::vector<Vec2> path;
  double length = 0;
  for (double t = 0; length < 33; t += 0.002) {
    path.push_back({14 * std::sin(t), 6 * (1 - std::cos(t))});
    if (path.size() > 1) length += glm::distance(path[path.size() - 2], path.back());
  }
  return path;
}

Walk recorded_walk(const std::vector<Vec2>& path, Fidelity fidelity) {
  WalkRequest request;
  request.path = path;
  request.fidelity = fidelity;
  return *make_walk(recorded_graph(), request);
}

TEST(RecordedWalk, FollowsThirtyThreeMetresOfAnEllipse) {
  NEEDS_REFERENCE_DATA("mocap/cmu-walk");
  const std::vector<Vec2> path = elliptic_arc();

  const Walk walk = recorded_walk(path, Fidelity::Exact);

  EXPECT_LT(test::largest_deviation(walk, path), 0.03);
  EXPECT_LT(glm::distance(walk.body.back().position, path.back()), 0.02);
  EXPECT_LT(test::largest_drift(recorded_graph().skeleton, walk), 0.005);
  EXPECT_GE(frame_count(walk) / walk.frame_rate / (walk.transitions + 1), 0.4);
}

TEST(RecordedWalk, FollowsTheEllipseByTheClipsAlone) {
  NEEDS_REFERENCE_DATA("mocap/cmu-walk");
  const std::vector<Vec2> path = elliptic_arc();

  const Walk walk = recorded_walk(path, Fidelity::Raw);

  EXPECT_LT(test::largest_deviation(walk, path), 0.12);
}

TEST(RecordedWalk, TurnsSharpCornersWithinReach) {
  NEEDS_REFERENCE_DATA("mocap/cmu-walk");
  const std::vector<Vec2> path{{0, 0}, {3, 0}, {3, 3}, {2.5, 0.5}, {6, 0.5}, {0, 0.5}};

  const Walk walk = recorded_walk(path, Fidelity::Exact);

  EXPECT_LT(test::largest_deviation(walk, path), 0.1);
  EXPECT_LT(test::largest_drift(recorded_graph().skeleton, walk), 0.005);
}

}  // namespace
}  // namespace docent::motion::recorded_walk_test
