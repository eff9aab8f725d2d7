#include "runtime/motion/walk.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "runtime/motion/path_track.h"
#include "runtime/motion/smoothing.h"
#include "runtime/motion/walk_graph.h"
#include "tests/runtime/motion/hand_made_graph.h"
#include "tests/runtime/motion/walk_measures.h"

namespace docent::motion::make_walk_test {
namespace {

const MotionGraph& motion() {
  static const MotionGraph graph = test::hand_made_graph();
  return graph;
}

const WalkGraph& walk_graph() {
  static const WalkGraph graph = *make_walk_graph(motion());
  return graph;
}

Walk walk_along(const std::vector<Vec2>& path, WalkRequest request = {}) {
  request.path = path;
  Result<Walk> walk = make_walk(walk_graph(), request);
  EXPECT_TRUE(walk.has_value()) << walk.error().what;
  return walk ? *walk : Walk{};
}

struct NamedPath {
  const char* name;
  std::vector<Vec2> points;
  double largest_deviation;  ///< Metres.
};

NamedPath loop() {
  NamedPath path{"loop", {}, 0.03};
  for (int i = 0; i <= 200; ++i) {
    const double a = 2 * std::numbers::pi * i / 200;
    path.points.push_back({2 * std::sin(a), 2 - 2 * std::cos(a)});
  }
  return path;
}

NamedPath s_shape() {
  NamedPath path{"s", {}, 0.03};
  for (int i = 0; i <= 100; ++i)
    path.points.push_back({0.08 * i, std::sin(2 * std::numbers::pi * i / 100)});
  return path;
}

class WalkAlong : public testing::TestWithParam<NamedPath> {};

TEST_P(WalkAlong, ArrivesStandingAtTheEndOfThePath) {
  const Walk walk = walk_along(GetParam().points);

  EXPECT_LT(glm::distance(walk.body.back().position, GetParam().points.back()), 0.02);
  EXPECT_LT(glm::distance(to_floor(walk.root.back()), GetParam().points.back()), 0.05);
  const test::Quickest end = test::quickest(walk, walk.root.size() - 6, walk.root.size());
  EXPECT_LT(end.root, 0.1);
}

TEST_P(WalkAlong, KeepsToThePath) {
  const Walk walk = walk_along(GetParam().points);

  EXPECT_LT(test::largest_deviation(walk, GetParam().points), GetParam().largest_deviation);
}

TEST_P(WalkAlong, KeepsPlantedFeetWhereTheyAre) {
  const Walk walk = walk_along(GetParam().points);

  EXPECT_LT(test::largest_drift(motion().skeleton, walk), 0.005);
  EXPECT_LT(test::deepest_toe(motion().skeleton, walk), 0.005);
}

TEST_P(WalkAlong, MovesNoFasterThanItsClips) {
  const Walk walk = walk_along(GetParam().points);

  const test::Quickest moves = test::quickest(walk, 0, walk.root.size());
  EXPECT_LT(test::haste(moves, test::quickest(motion())), 1.15);
}

TEST_P(WalkAlong, SaysHowFarItHasCome) {
  const Walk walk = walk_along(GetParam().points);

  for (std::size_t f = 1; f < walk.along.size(); ++f) EXPECT_GE(walk.along[f], walk.along[f - 1]);
  EXPECT_NEAR(walk.along.back(), polyline_length(GetParam().points), 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, WalkAlong,
    testing::Values(NamedPath{"straight", {{0, 0}, {8, 0}}, 0.03},
                    NamedPath{"rightAngle", {{0, 0}, {4, 0}, {4, -4}}, 0.08},
                    NamedPath{"u", {{0, 0}, {4, 0}, {4, 1.2}, {0, 1.2}}, 0.08},
                    NamedPath{"turnBack", {{0, 0}, {4, 0}, {0, 0}}, 0.1},
                    NamedPath{"zigzag", {{0, 0}, {3, 0}, {4, 2}, {6, -1}, {8, 2}, {11, 2}}, 0.1},
                    NamedPath{"twoMetres", {{0, 0}, {0, 2}}, 0.03},
                    NamedPath{"oneStep", {{5, 5}, {5, 4.5}}, 0.06},
                    NamedPath{"handsBreadth", {{5, 5}, {5.1, 5}}, 0.06}, loop(), s_shape()),
    [](const auto& each) { return std::string(each.param.name); });

RC_GTEST_PROP(AnyWalk, ArrivesAndNeverLeavesThePath, ()) {
  const int corners = *rc::gen::inRange(1, 7);
  std::vector<Vec2> path{{0, 0}};
  for (int i = 0; i < corners; ++i) {
    const double angle = *rc::gen::inRange(0, 360) * std::numbers::pi / 180;
    const double length = *rc::gen::inRange(5, 400) / 100.0;
    path.push_back(path.back() + length * Vec2(std::cos(angle), std::sin(angle)));
  }
  RC_PRE(glm::distance(path.front(), path.back()) > 0.01 || polyline_length(path) > 0.1);
  WalkRequest request;
  request.path = path;
  if (*rc::gen::arbitrary<bool>())
    request.final_heading = *rc::gen::inRange(-180, 180) * std::numbers::pi / 180;

  const Result<Walk> walk = make_walk(walk_graph(), request);

  RC_ASSERT(walk.has_value());
  RC_ASSERT(glm::distance(walk->body.back().position, path.back()) < 0.05);
  RC_ASSERT(test::largest_deviation(*walk, path) < 0.2);
  RC_ASSERT(test::largest_drift(motion().skeleton, *walk) < 0.02);
  const test::Quickest moves = test::quickest(*walk, 0, walk->root.size());
  RC_ASSERT(test::haste(moves, test::quickest(motion())) < 1.15);
  if (request.final_heading)
    RC_ASSERT(std::abs(wrap_angle(walk->body.back().heading - *request.final_heading)) < 0.09);
  for (const Quat& q : walk->rotation) RC_ASSERT(std::abs(glm::length(q) - 1) < 1e-3f);
}

class TurnOnTheSpot : public testing::TestWithParam<int> {};

TEST_P(TurnOnTheSpot, FacesWhereItShouldByStepsThatStayInPlace) {
  const double angle = GetParam() * std::numbers::pi / 180;
  WalkRequest request;
  request.start = Placement{{3, 3}, 0.4};
  request.final_heading = 0.4 + angle;

  const Walk walk = walk_along({{3, 3}, {3, 3.001}}, request);

  EXPECT_NEAR(wrap_angle(walk.body.back().heading - 0.4 - angle), 0, 0.01);
  EXPECT_LT(test::largest_drift(motion().skeleton, walk), 0.002);
  for (const Vec3& root : walk.root) EXPECT_LT(glm::distance(to_floor(root), {3, 3}), 0.12);
  for (const Gait gait : walk.gait) EXPECT_EQ(gait, Gait::Turn);
  EXPECT_LT(test::quickest(walk, 0, walk.root.size()).joint, 12);
}

INSTANTIATE_TEST_SUITE_P(Degrees, TurnOnTheSpot, testing::Values(20, 90, 179, -30, -135),
                         [](const auto& each) {
                           return std::string(each.param < 0 ? "Right" : "Left") +
                                  std::to_string(std::abs(each.param));
                         });

TEST(MakeWalk, TurnsFirstWhereThePathLeadsBackwards) {
  WalkRequest request;
  request.start = Placement{{0, 0}, std::numbers::pi};

  const Walk walk = walk_along({{0, 0}, {5, 0}}, request);

  EXPECT_EQ(walk.gait.front(), Gait::Turn);
  EXPECT_EQ(walk.gait.back(), Gait::Walk);
  EXPECT_LT(glm::distance(walk.body.back().position, {5, 0}), 0.02);
}

TEST(MakeWalk, KeepsARawTrackNearThePathToo) {
  WalkRequest request;
  request.fidelity = Fidelity::Raw;
  const std::vector<Vec2> path = loop().points;

  const Walk walk = walk_along(path, request);

  // The hand-made clips can only be cut at whole strides, so the end may be half a stride off.
  EXPECT_LT(test::largest_deviation(walk, path), 0.6);
  EXPECT_LT(glm::distance(to_floor(walk.root.back()), path.back()), 0.6);
}

TEST(MakeWalk, GivesTheSameWalkEveryTime) {
  const std::vector<Vec2> path = s_shape().points;

  const Walk first = walk_along(path), second = walk_along(path);

  EXPECT_EQ(first.root, second.root);
  EXPECT_EQ(first.rotation, second.rotation);
}

TEST(MakeWalk, RefusesAPathWithoutAPoint) {
  const Result<Walk> walk = make_walk(walk_graph(), {});

  ASSERT_FALSE(walk.has_value());
  EXPECT_EQ(walk.error().what, "the path has no point to walk to");
}

TEST(MakeWalk, StandsStillWhereThePathLeadsNowhere) {
  const Walk walk = walk_along({{2, 2}, {2, 2}});

  ASSERT_FALSE(walk.root.empty());
  EXPECT_LT(glm::distance(to_floor(walk.root.back()), {2, 2}), 0.05);
}

TEST(MakeWalkGraph, SaysWhatIsMissing) {
  MotionGraph none;
  MotionGraph no_stop = motion();
  no_stop.clips[2].role = ClipRole::Other;
  MotionGraph no_way = motion();
  no_way.transitions.clear();

  EXPECT_EQ(make_walk_graph(none).error().what,
            "the museum holds no walking clips: compile it without --no-motion");
  EXPECT_EQ(make_walk_graph(no_stop).error().what, "no clip ends walking and stands still");
  EXPECT_EQ(make_walk_graph(no_way).error().what,
            "no transitions lead from a start clip to a stop clip");
}

}  // namespace
}  // namespace docent::motion::make_walk_test
