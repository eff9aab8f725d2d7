#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "runtime/motion/path_track.h"
#include "runtime/motion/smoothing.h"
#include "runtime/motion/walk.h"
#include "runtime/motion/walk_graph.h"
#include "tests/runtime/motion/hand_made_graph.h"
#include "tests/runtime/motion/walk_measures.h"

namespace docent::motion::walk_splice_test {
namespace {

const MotionGraph& motion() {
  static const MotionGraph graph = test::hand_made_graph();
  return graph;
}

const WalkGraph& walk_graph() {
  static const WalkGraph graph = *make_walk_graph(motion());
  return graph;
}

const std::vector<Vec2>& straight_path() {
  static const std::vector<Vec2> path{{0, 0}, {9, 0}};
  return path;
}

const Walk& straight_walk() {
  static const Walk walk = [] {
    WalkRequest request;
    request.path = straight_path();
    return *make_walk(walk_graph(), request);
  }();
  return walk;
}

/// Interrupts the straight walk and sends it off in a direction.
struct Interruption {
  std::uint32_t frame;
  int degrees;
};

class Interrupted : public testing::TestWithParam<Interruption> {
 protected:
  Interrupted() {
    const Placement& body = straight_walk().body[GetParam().frame];
    const double angle = body.heading + GetParam().degrees * std::numbers::pi / 180;
    path = {body.position, body.position + 4.0 * Vec2(std::cos(angle), std::sin(angle))};
    const std::vector<Vec2> ahead{body.position, straight_path().back()};
    WalkRequest request;
    request.path = path;
    request.previous = &straight_walk();
    request.previous_frame = GetParam().frame;
    request.old_path_ahead = ahead;
    walk = *make_walk(walk_graph(), request);
    whole = test::spliced(straight_walk(), GetParam().frame, walk);
  }

  std::vector<Vec2> path;
  Walk walk, whole;
};

TEST_P(Interrupted, BeginsWithTheFrameThatItGoesOnFrom) {
  const std::uint32_t frame = GetParam().frame;

  EXPECT_LT(glm::distance(walk.root.front(), straight_walk().root[frame]), 1e-4f);
  for (std::size_t j = 0; j < walk.joint_count; ++j)
    EXPECT_GT(std::abs(glm::dot(walk.rotation[j],
                                straight_walk().rotation[frame * walk.joint_count + j])),
              1 - 1e-5f);
}

TEST_P(Interrupted, GoesOnWithoutAJump) {
  const std::size_t frame = GetParam().frame;
  const test::Quickest ordinary = test::quickest(straight_walk(), 0, straight_walk().root.size());

  const test::Quickest splice = test::quickest(whole, frame - 3, frame + 60);

  EXPECT_LT(splice.root, 1.15 * ordinary.root);
  EXPECT_LT(splice.joint, 1.15 * ordinary.joint);
  EXPECT_LT(splice.root_change, 2 * ordinary.root_change);
  EXPECT_LT(splice.joint_change, 2 * ordinary.joint_change);
}

TEST_P(Interrupted, KeepsThePlantedFootWhereItIs) {
  EXPECT_LT(test::largest_drift(motion().skeleton, whole), 0.01);
}

TEST_P(Interrupted, ArrivesAtTheNewGoal) {
  EXPECT_LT(glm::distance(walk.body.back().position, path.back()), 0.03);
}

TEST_P(Interrupted, SaysHowFarItHasComeOnTheNewPath) {
  for (std::size_t f = 1; f < walk.along.size(); ++f) EXPECT_GE(walk.along[f], walk.along[f - 1]);
  EXPECT_EQ(walk.along.front(), 0);
  EXPECT_NEAR(walk.along.back(), polyline_length(path), 0.02);
}

TEST_P(Interrupted, StaysBetweenTheOldPathAndTheNew) {
  std::vector<Vec2> both = path;
  both.insert(both.begin(), straight_path().back());

  EXPECT_LT(test::largest_deviation(walk, both), 0.15);
}

INSTANTIATE_TEST_SUITE_P(Walks, Interrupted,
                         testing::Values(Interruption{60, 0}, Interruption{300, 20},
                                         Interruption{330, -50}, Interruption{360, 90},
                                         Interruption{390, -120}, Interruption{420, 180},
                                         Interruption{500, 45}),
                         [](const auto& each) {
                           return "At" + std::to_string(each.param.frame) +
                                  (each.param.degrees < 0 ? "Right" : "Left") +
                                  std::to_string(std::abs(each.param.degrees));
                         });

TEST(RestlessVisitors, NeverMakeTheWalkerJumpOrMissItsGoal) {
  std::mt19937 random(4);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 10000) / 10000;
  };
  const test::Quickest clips = test::quickest(motion());
  Walk walk = straight_walk();
  for (int call = 0; call < 60; ++call) {
    const std::uint32_t frame = static_cast<std::uint32_t>(random()) % frame_count(walk);
    std::vector<Vec2> path{walk.body[frame].position}, ahead;
    for (std::size_t f = frame; f < walk.body.size(); f += 12)
      ahead.push_back(walk.body[f].position);
    for (int corner = 0; corner < 1 + call % 4; ++corner)
      path.push_back(path.back() + Vec2(between(-4, 4), between(-4, 4)));
    WalkRequest request;
    request.path = path;
    request.previous = &walk;
    request.previous_frame = frame;
    request.old_path_ahead = ahead;

    const Walk next = *make_walk(walk_graph(), request);

    const Walk whole = test::spliced(walk, frame, next);
    const test::Quickest moves = test::quickest(whole, frame, whole.root.size());
    EXPECT_LT(glm::distance(next.body.back().position, path.back()), 0.03) << call;
    EXPECT_LT(test::haste(moves, clips), 1.15) << call;
    walk = next;
  }
}

TEST(StoppedWalk, StandsWithinTwoSteps) {
  WalkRequest request;
  request.previous = &straight_walk();
  request.previous_frame = 400;

  const Walk walk = *make_walk(walk_graph(), request);

  const Vec2 from = straight_walk().body[400].position;
  EXPECT_LT(glm::distance(walk.body.back().position, from), 2.5);
  EXPECT_LT(test::quickest(walk, walk.root.size() - 6, walk.root.size()).root, 0.1);
}

TEST(StandingWalker, GoesOnFromWhereItsFeetAre) {
  const Walk& before = straight_walk();
  const auto last = frame_count(before) - 1;
  const std::vector<Vec2> path{before.body[last].position, {9, 4}};
  WalkRequest request;
  request.path = path;
  request.previous = &before;
  request.previous_frame = last;

  const Walk walk = *make_walk(walk_graph(), request);

  EXPECT_EQ(walk.gait.front(), Gait::Turn);
  EXPECT_LT(test::largest_drift(motion().skeleton, test::spliced(before, last, walk)), 0.005);
  EXPECT_LT(glm::distance(walk.body.back().position, path.back()), 0.02);
}

TEST(TurningWalker, CanBeCalledElsewhere) {
  WalkRequest first;
  const std::vector<Vec2> there{{0, 0}, {4, 0}}, elsewhere{{0, 0}, {0, -4}};
  first.path = there;
  first.start = Placement{{0, 0}, std::numbers::pi};
  const Walk before = *make_walk(walk_graph(), first);
  for (const std::uint32_t frame : {10u, 50u, 80u, 110u}) {
    ASSERT_EQ(before.gait[frame], Gait::Turn);
    WalkRequest second;
    second.path = elsewhere;
    second.previous = &before;
    second.previous_frame = frame;

    const Walk walk = *make_walk(walk_graph(), second);

    const Walk whole = test::spliced(before, frame, walk);
    EXPECT_LT(test::quickest(whole, frame - 3, frame + 40).joint, 14);
    EXPECT_LT(test::largest_drift(motion().skeleton, whole), 0.005);
    EXPECT_LT(glm::distance(walk.body.back().position, elsewhere.back()), 0.03);
  }
}

}  // namespace
}  // namespace docent::motion::walk_splice_test
