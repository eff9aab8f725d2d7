#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "runtime/motion/search.h"
#include "runtime/motion/walk.h"
#include "tests/runtime/motion/hand_made_graph.h"
#include "tests/runtime/motion/walk_measures.h"

namespace docent::motion::search_test {
namespace {

/// The hand-made clips, of which the one that turns left counts as a brisk walk and the one that
/// turns right as a run.
MotionGraph with_classes() {
  MotionGraph motion = test::hand_made_graph();
  for (MotionClip& clip : motion.clips) {
    if (clip.role == ClipRole::TurnLeft) clip.motion_class = "brisk-walk";
    if (clip.role == ClipRole::TurnRight) clip.motion_class = "run";
  }
  motion.classes = {{.name = "run", .coefficient = {0, 4, 3}},
                    {.name = "walk", .coefficient = {4, 0, 1}},
                    {.name = "brisk-walk", .coefficient = {3, 1, 0}}};
  for (MotionClass& motion_class : motion.classes)
    for (std::uint32_t t = 0; t < motion.transitions.size(); ++t) {
      const Transition& way = motion.transitions[t];
      if (motion.clips[way.from.clip].motion_class == motion_class.name &&
          motion.clips[way.to.clip].motion_class == motion_class.name)
        motion_class.transition.push_back(t);
    }
  return motion;
}

const MotionGraph& motion() {
  static const MotionGraph motion = with_classes();
  return motion;
}
const WalkGraph& graph() {
  static const WalkGraph graph = *make_walk_graph(motion());
  return graph;
}

std::vector<Vec2> straight() {
  return {{0, 0}, {10, 0}};
}

/// Straight on, a quarter turn of the clips' own radius, straight on. To the left for side = 1, to
/// the right for -1.
std::vector<Vec2> bend(double side) {
  std::vector<Vec2> path{{0, 0}};
  for (int i = 0; i <= 40; ++i) {
    const double a = 1.5707963 * i / 40;
    path.emplace_back(2 + 2.1 * std::sin(a), side * 2.1 * (1 - std::cos(a)));
  }
  path.push_back(path.back() + side * Vec2{0, 2});
  return path;
}

Walk walk_along(const WalkGraph& on, const std::vector<Vec2>& path, Fidelity fidelity) {
  WalkRequest request;
  request.path = path;
  request.fidelity = fidelity;
  return make_walk(on, request).value();
}

std::set<std::string> classes_of(const Walk& walk) {
  std::set<std::string> classes;
  for (const ClipFrame& source : walk.source)
    classes.insert(motion().clips[source.clip].motion_class);
  return classes;
}

using Classes = std::set<std::string>;

TEST(MotionClasses, AreRankedByHowMuchTheyAreLikeWalking) {
  EXPECT_EQ(graph().scopes, 3u);
  for (std::size_t c = 0; c < graph().clip.size(); ++c) {
    const std::string& name = motion().clips[c].motion_class;
    EXPECT_EQ(graph().clip[c].rank, name == "walk" ? 0u : name == "brisk-walk" ? 1u : 2u);
  }
}

TEST(MotionClasses, HaveGraphsOfTheirOwnThatLeadToAStand) {
  const ClipPath& start = graph().clip[graph().starts.front()];
  EXPECT_TRUE(std::isfinite(start.to_stand[0][start.first]));
  for (const ClipPath& clip : graph().clip)
    for (std::uint32_t scope = 0; scope < clip.rank; ++scope)
      for (const double left : clip.to_stand[scope]) EXPECT_FALSE(std::isfinite(left));
}

TEST(MotionClasses, OfOneNameOrNoneAreOneScope) {
  const MotionGraph classless = test::hand_made_graph();

  EXPECT_EQ(make_walk_graph(classless)->scopes, 1u);
}

TEST(SearchWithClasses, StaysInItsClassWhereThatSuffices) {
  for (const Fidelity fidelity : {Fidelity::Raw, Fidelity::Exact}) {
    const Walk walk = walk_along(graph(), straight(), fidelity);

    EXPECT_EQ(walk.scope, 0u);
    EXPECT_EQ(classes_of(walk), Classes{"walk"});
  }
}

TEST(SearchWithClasses, CrossesOnlyToTheClassThatTheMotionNeeds) {
  const Walk left = walk_along(graph(), bend(1), Fidelity::Exact);
  EXPECT_EQ(left.scope, 1u);
  EXPECT_EQ(classes_of(left), (Classes{"walk", "brisk-walk"}));

  const Walk right = walk_along(graph(), bend(-1), Fidelity::Exact);
  EXPECT_EQ(right.scope, 2u);
  EXPECT_TRUE(classes_of(right).contains("run"));
}

TEST(SearchWithClasses, LooksAtLessOfTheGraphAndKeepsToThePathAsWell) {
  MotionGraph classless = motion();
  classless.classes.clear();
  const WalkGraph whole = *make_walk_graph(classless);
  for (const auto& path : {straight(), bend(1), bend(-1)}) {
    const Walk walk = walk_along(graph(), path, Fidelity::Raw);
    const Walk without = walk_along(whole, path, Fidelity::Raw);

    EXPECT_LT(test::largest_deviation(walk, path), test::largest_deviation(without, path) + 0.02);
  }
  EXPECT_LT(walk_along(graph(), straight(), Fidelity::Raw).considered,
            walk_along(whole, straight(), Fidelity::Raw).considered);
}

TEST(SearchWithClasses, DoesNotBeginAnewWhereItsClassDoesNotSuffice) {
  MotionGraph classless = motion();
  classless.classes.clear();
  const WalkGraph whole = *make_walk_graph(classless);
  const std::vector<Vec2> path = bend(1);

  const Walk walk = walk_along(graph(), path, Fidelity::Exact);

  EXPECT_EQ(walk.scope, 1u);
  EXPECT_LT(walk.considered, 1.1 * walk_along(whole, path, Fidelity::Exact).considered);
}

TEST(SearchWithClasses, TakesOnlyTransitionsOfItsClassOwnGraph) {
  MotionGraph motion = with_classes();
  std::vector<std::uint32_t>& own = motion.classes[1].transition;
  ASSERT_GT(own.size(), 2U);
  const std::uint32_t left_out = own[own.size() / 2];
  std::erase(own, left_out);

  const WalkGraph graph = *make_walk_graph(motion);

  EXPECT_FALSE(leads_to_stand(graph, left_out, 0));
  EXPECT_FALSE(leads_to_stand(graph, left_out, 1));
  EXPECT_TRUE(leads_to_stand(graph, left_out, 2));
}

TEST(SearchWithClasses, GoesOnFromAnyClass) {
  const Walk before = walk_along(graph(), bend(1), Fidelity::Raw);
  std::uint32_t frame = 0;
  while (motion().clips[before.source[frame].clip].motion_class != "brisk-walk") ++frame;
  const Placement body = before.body[frame];
  const std::array path{body.position,
                        body.position + 5.0 * Vec2(std::cos(body.heading), std::sin(body.heading))};
  WalkRequest request;
  request.path = path;
  request.previous = &before;
  request.previous_frame = frame;

  const Walk walk = make_walk(graph(), request).value();

  EXPECT_GE(walk.scope, 1u);
  EXPECT_EQ(walk.gait[frame_count(walk) / 2], Gait::Walk);
  EXPECT_LT(glm::distance(walk.body.back().position, path.back()), 0.02);
}

TEST(SearchWithClasses, FindsAWayWhereItsClassCannotStop) {
  MotionGraph motion = with_classes();
  for (MotionClip& clip : motion.clips)
    if (clip.role == ClipRole::Stop) clip.motion_class = "run";
  const WalkGraph graph = *make_walk_graph(motion);

  const Walk walk = walk_along(graph, straight(), Fidelity::Exact);

  EXPECT_EQ(walk.scope, 2u);
  EXPECT_LT(glm::distance(walk.body.back().position, straight().back()), 0.02);
}

}  // namespace
}  // namespace docent::motion::search_test
