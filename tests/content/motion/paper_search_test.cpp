#include "content/motion/paper_search.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "content/motion/paper_track.h"
#include "content/motion/transition_section.h"
#include "tests/content/motion/random_graph.h"
#include "tests/content/motion/shipped_clips.h"

namespace docent::test::paper_search_test {
namespace {

std::vector<Vec2> arc(double length, double bend) {
  std::vector<Vec2> path{{0, 0}};
  for (double s = 0; s < length; s += 0.02)
    path.push_back(path.back() +
                   std::min(length - s, 0.02) * Vec2{std::cos(bend * s), std::sin(bend * s)});
  return path;
}

double length_of(const std::vector<Vec2>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += glm::distance(path[i - 1], path[i]);
  return length;
}

std::vector<Vec2> roots_of(const MotionGraph& graph, const motion::offline::PaperPath& path,
                           const Placement& clip_to_floor) {
  std::vector<Vec2> roots;
  for (const Vec3 root : motion::offline::make_paper_track(graph, path, clip_to_floor).root)
    roots.push_back(to_floor(root));
  return roots;
}

Vec2 point_at(const std::vector<Vec2>& path, double length) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double step = glm::distance(path[i - 1], path[i]);
    if (length <= step) return glm::mix(path[i - 1], path[i], length / step);
    length -= step;
  }
  return path.back();
}

/// D of a whole track, from its frames; infinite where it is shorter than the path.
double difference(const std::vector<Vec2>& roots, const std::vector<Vec2>& path) {
  const double goal = length_of(path);
  double length = 0, squares = 0;
  for (std::size_t f = 1; f < roots.size() && length < goal; ++f) {
    const double step = glm::distance(roots[f - 1], roots[f]);
    const Vec2 gap = roots[f] - point_at(path, length + step);
    squares += std::min(step, goal - length) * dot(gap, gap);
    length += step;
  }
  return length + 1e-5 < goal ? std::numeric_limits<double>::infinity() : squares / goal;
}

/// The least D of any walk as long as the path: every sequence of transitions is tried.
class EveryWalk {
 public:
  EveryWalk(const MotionGraph& graph, const motion::offline::PaperRequest& request,
            const std::vector<Vec2>& path)
      : graph_(graph),
        sections_(motion::offline::measure_sections(graph)),
        request_(request),
        path_(path) {
    tried_.start = request.start;
    tried_.frames = std::numeric_limits<std::uint32_t>::max();
    go_on(request.start);
  }

  [[nodiscard]] double least() const { return least_; }
  [[nodiscard]] bool are_too_many() const { return tries_ >= most_tries; }

 private:
  static constexpr int most_tries = 2000;

  void go_on(ClipFrame at) {
    if (++tries_ >= most_tries) return;
    tried_.last_frame = frame_count(graph_.clips[at.clip]) - 1;
    least_ = std::min(least_, difference(roots_of(graph_, tried_, request_.clip_to_floor), path_));
    tried_.last_frame = at.frame;
    if (length_of(roots_of(graph_, tried_, request_.clip_to_floor)) >= length_of(path_)) return;
    for (std::uint32_t t = 0; t < graph_.transitions.size(); ++t) {
      const Transition& way = graph_.transitions[t];
      if (way.from.clip != at.clip) continue;
      const auto radius = motion::offline::section_radius(graph_, sections_, t, at.frame);
      if (!radius) continue;
      tried_.passed.push_back({t, *radius});
      go_on({way.to.clip, way.to.frame + *radius});
      tried_.passed.pop_back();
    }
  }

  const MotionGraph& graph_;
  motion::offline::TransitionSections sections_;
  const motion::offline::PaperRequest& request_;
  const std::vector<Vec2>& path_;
  motion::offline::PaperPath tried_;
  double least_ = std::numeric_limits<double>::infinity();
  int tries_ = 0;
};

RC_GTEST_PROP(PaperSearch, FindsTheBestOfAllWalksWithinItsLookahead, ()) {
  const MotionGraph graph = *random_graph();
  const std::vector<Vec2> path =
      arc(0.01 * *rc::gen::inRange(30, 90) + 0.005, 0.1 * *rc::gen::inRange(-20, 21));
  const motion::offline::PaperRequest request{
      .path = path, .start = {0, 0}, .clip_to_floor = {}, .lookahead = 10};

  const EveryWalk every(graph, request, path);
  RC_PRE(!every.are_too_many());
  const double least = every.least();

  const motion::offline::PaperPath found = motion::offline::find_paper_path(graph, request);

  RC_ASSERT(found.reaches_end == std::isfinite(least));
  if (!found.reaches_end) return;
  const std::vector<Vec2> roots = roots_of(graph, found, request.clip_to_floor);
  RC_ASSERT(roots.size() == found.frames);
  RC_ASSERT(length_of(roots) < length_of(path) + 0.02);  // A frame walks 1 cm.
  RC_ASSERT(std::abs(difference(roots, path) - least) < 1e-5);
}

RC_GTEST_PROP(PaperSearch, FindsTheSameSoonerWhenItGivesUpOnTheWay, ()) {
  const MotionGraph graph = *random_graph();
  const std::vector<Vec2> path = arc(1.5, 0.1 * *rc::gen::inRange(-20, 21));
  motion::offline::PaperRequest request{.path = path,
                                        .start = {0, 0},
                                        .clip_to_floor = {{1, 2}, 0.5},
                                        .lookahead = 0.1 * *rc::gen::inRange(1, 6),
                                        .use_rate = 0.1 * *rc::gen::inRange(1, 11)};

  const motion::offline::PaperPath printed = motion::offline::find_paper_path(graph, request);
  request.bound = motion::offline::PaperRequest::Bound::OnTheWay;
  const motion::offline::PaperPath bounded = motion::offline::find_paper_path(graph, request);

  RC_ASSERT(bounded.expanded <= printed.expanded);
  RC_ASSERT(bounded.frames == printed.frames);
  RC_ASSERT(std::ranges::equal(
      bounded.passed, printed.passed,
      [](motion::offline::PassedTransition a, motion::offline::PassedTransition b) {
        return a.transition == b.transition && a.radius == b.radius;
      }));
}

/// The shipped clips along 10 m that bend, as a walker would be asked to.
struct WalkOfShippedClips {
  std::vector<Vec2> path = arc(10, 0.15);
  motion::offline::PaperRequest request{
      .path = path, .start = {}, .clip_to_floor = {}, .lookahead = 0.8};
  WalkOfShippedClips() {
    const auto& clips = shipped_graph().clips;
    const auto start = std::ranges::find(clips, ClipRole::Start, &MotionClip::role);
    request.start.clip = static_cast<std::uint32_t>(start - clips.begin());
    const Vec2 first = to_floor(start->root.front());
    const Vec2 way = to_floor(start->root.back()) - first;
    request.clip_to_floor.heading = -std::atan2(way.y, way.x);
    request.clip_to_floor.position = -motion::offline::carried(request.clip_to_floor, first);
  }
};

RC_GTEST_PROP(PaperSearch, ReachesTheEndOfEveryPathBecauseItKeepsAnExit, ()) {
  WalkOfShippedClips walk;
  walk.path = arc(*rc::gen::inRange(2, 20), 0.1 * *rc::gen::inRange(-10, 11));
  walk.request.path = walk.path;
  walk.request.lookahead = 0.1 * *rc::gen::inRange(1, 9);
  walk.request.use_rate = 0.1 * *rc::gen::inRange(1, 11);

  RC_ASSERT(motion::offline::find_paper_path(shipped_graph(), walk.request).reaches_end);
}

TEST(PaperSearch, PlaysFramesForwardsOnly) {
  const WalkOfShippedClips walk;

  const motion::offline::PaperPath path =
      motion::offline::find_paper_path(shipped_graph(), walk.request);

  ASSERT_TRUE(path.reaches_end);
  const motion::offline::PaperTrack track =
      motion::offline::make_paper_track(shipped_graph(), path, walk.request.clip_to_floor);
  std::size_t changes = 0;
  for (std::size_t f = 1; f < track.source.size(); ++f) {
    const ClipFrame before = track.source[f - 1], now = track.source[f];
    const bool continues = now.clip == before.clip && now.frame == before.frame + 1;
    changes += !continues;
  }
  EXPECT_LE(changes, path.passed.size());
  EXPECT_GT(path.passed.size(), 3U);
}

TEST(PaperSearch, MakesATrackWithoutLeapsAsLongAsThePath) {
  const WalkOfShippedClips walk;

  const motion::offline::PaperPath path =
      motion::offline::find_paper_path(shipped_graph(), walk.request);

  const std::vector<Vec2> roots = roots_of(shipped_graph(), path, walk.request.clip_to_floor);
  double longest = 0;
  for (std::size_t f = 1; f < roots.size(); ++f)
    longest = std::max(longest, glm::distance(roots[f - 1], roots[f]));
  EXPECT_NEAR(length_of(roots), length_of(walk.path), 0.02);
  EXPECT_LT(longest, 0.02) << "2.4 m/s";
  EXPECT_LT(glm::distance(roots.back(), walk.path.back()), 0.5);
}

TEST(PaperSearch, KeepsWhatItHasWhenTheTimeIsUp) {
  WalkOfShippedClips walk;
  walk.request.time_limit = 0;

  const motion::offline::PaperPath path =
      motion::offline::find_paper_path(shipped_graph(), walk.request);

  EXPECT_FALSE(path.reaches_end);
  EXPECT_EQ(path.length, 0);
  EXPECT_EQ(motion::offline::make_paper_track(shipped_graph(), path, walk.request.clip_to_floor)
                .root.size(),
            1U);
}

TEST(PaperSearch, LookingFartherAheadKeepsCloserToThePath) {
  WalkOfShippedClips walk;
  const auto farthest_off = [&](double lookahead) {
    walk.request.lookahead = lookahead;
    const motion::offline::PaperPath path =
        motion::offline::find_paper_path(shipped_graph(), walk.request);
    return difference(roots_of(shipped_graph(), path, walk.request.clip_to_floor), walk.path);
  };

  EXPECT_LT(farthest_off(1.0), farthest_off(0.3));
}

}  // namespace
}  // namespace docent::test::paper_search_test
