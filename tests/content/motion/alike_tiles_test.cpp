#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "content/motion/alike_tiles.h"
#include "content/motion/find_transitions.h"
#include "content/motion/foot_plants.h"
#include "content/motion/nearest_poses.h"
#include "tests/content/motion/shipped_clips.h"
#include "tests/support/sanitized.h"

namespace docent::test::alike_tiles_test {
namespace {

/// Clips as find_transitions takes them.
struct Studied {
  std::vector<MotionClip> clips;
  motion::offline::StudiedClips studied;

  void add(MotionClip clip) {
    const Skeleton& skeleton = shipped_clips().skeleton;
    const motion::offline::JointPositions track = motion::offline::joint_positions(skeleton, clip);
    motion::offline::find_foot_plants(skeleton, track, clip);
    studied.cloud.push_back(motion::offline::make_pose_cloud(skeleton, track));
    studied.faults.push_back(motion::offline::find_capture_faults(skeleton, clip, track));
    clips.push_back(std::move(clip));
  }
  std::vector<Transition> transitions(const motion::offline::TransitionOptions& options,
                                      unsigned jobs = 1) const {
    return motion::offline::find_transitions(
        clips, studied, motion::offline::alike_thresholds(clips, studied, options), options, jobs);
  }
};

Studied all_shipped() {
  Studied studied;
  for (const motion::offline::SourceClip& source : shipped_clips().clips) studied.add(source.clip);
  return studied;
}

/// Some frames of a clip, from `first` on.
MotionClip part_of(const MotionClip& clip, std::size_t first, std::size_t frames) {
  MotionClip part = clip;
  const auto from = static_cast<std::ptrdiff_t>(first), count = static_cast<std::ptrdiff_t>(frames),
             joints = static_cast<std::ptrdiff_t>(clip.joint_count);
  part.root.assign(clip.root.begin() + from, clip.root.begin() + from + count);
  part.rotation.assign(clip.rotation.begin() + from * joints,
                       clip.rotation.begin() + (from + count) * joints);
  return part;
}

using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

std::set<Key> keys(const std::vector<Transition>& transitions) {
  std::set<Key> keys;
  for (const Transition& t : transitions)
    keys.insert({t.from.clip, t.from.frame, t.to.clip, t.to.frame});
  return keys;
}

constexpr motion::offline::TransitionOptions by_matrix{.per_window = 1000,
                                                       .compare_all_up_to = 1'000'000};
constexpr motion::offline::TransitionOptions by_index{.per_window = 1000, .compare_all_up_to = 0};

TEST(NearestPoses, AreThoseThatSortingAllByDistanceFinds) {
  EXPECT_TRUE(rc::check([] {
    // Few places, so that many are equally far.
    const auto points = *rc::gen::container<std::vector<motion::offline::PoseFeatures::Point>>(
        rc::gen::map(rc::gen::pair(rc::gen::inRange(0, 9), rc::gen::inRange(0, 9)),
                     [](std::pair<int, int> xy) {
                       motion::offline::PoseFeatures::Point point{};
                       point[3] = static_cast<float>(xy.first);
                       point[17] = 0.5f * static_cast<float>(xy.second);
                       return point;
                     }));
    RC_PRE(!points.empty());
    const auto count = *rc::gen::inRange<std::size_t>(1, 40);
    const auto within = 0.5f * static_cast<float>(*rc::gen::inRange(0, 12));
    const motion::offline::PoseFeatures::Point& about =
        points[*rc::gen::inRange<std::size_t>(0, points.size())];
    std::vector<motion::offline::NearestPoses::Neighbour> expected;
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (const float square = motion::offline::square_between(about, points[i]);
          square <= within * within)
        expected.push_back({square, i});
    std::ranges::sort(expected);
    expected.resize(std::min(count, expected.size()));

    std::vector<motion::offline::NearestPoses::Neighbour> found;
    motion::offline::NearestPoses(points).find(about, count, within, found);

    RC_ASSERT(found == expected);
  }));
}

TEST(PoseFeatures, AreAsFarApartAsPosesThatAreAlike) {
  const Studied shipped = all_shipped();
  const motion::offline::PoseFeatures features =
      motion::offline::make_pose_features(shipped.studied.cloud, 18, 1);
  std::size_t compared = 0, close = 0;
  for (const Transition& t : shipped.transitions(by_matrix)) {
    const double apart = std::sqrt(static_cast<double>(motion::offline::square_between(
        features.at(t.from.clip, t.from.frame), features.at(t.to.clip, t.to.frame))));
    ++compared;
    close += apart > 0.8 * static_cast<double>(t.distance) &&
             apart < 1.2 * static_cast<double>(t.distance) + 0.003;
  }

  EXPECT_GT(compared, 200U);
  EXPECT_GT(close, compared * 9 / 10);
}

TEST(PoseFeatures, DoNotDependOnWhereAClipIsOnTheFloor) {
  Studied moved;
  MotionClip clip = shipped_clips().named("walk");
  moved.add(clip);
  const Quat turn = glm::angleAxis(2.0f, Vec3{0, 1, 0});
  for (std::size_t f = 0; f < clip.root.size(); ++f) {
    clip.root[f] = turn * clip.root[f] + Vec3{3, 0, -5};
    clip.rotation[f * clip.joint_count] = turn * clip.rotation[f * clip.joint_count];
  }
  moved.add(clip);

  const motion::offline::PoseFeatures features =
      motion::offline::make_pose_features(moved.studied.cloud, 18, 1);

  for (std::size_t f = 0; f < clip.root.size(); ++f)
    EXPECT_LT(motion::offline::square_between(features.at(0, f), features.at(1, f)), 1e-6f) << f;
}

TEST(Transitions, FoundByIndexAreThoseOfTheWholeMatrix) {
  NEEDS_SPEED();
  EXPECT_TRUE(rc::check([] {
    Studied some;
    const auto count = *rc::gen::inRange<std::size_t>(2, 5);
    for (std::size_t c = 0; c < count; ++c) {
      const auto which = *rc::gen::inRange<std::size_t>(0, shipped_clips().clips.size());
      const MotionClip& clip = shipped_clips().clips[which].clip;
      const std::size_t frames = clip.root.size();
      const auto first = *rc::gen::inRange<std::size_t>(0, frames / 3);
      const auto last = *rc::gen::inRange<std::size_t>(2 * frames / 3, frames);
      some.add(part_of(clip, first, last - first));
    }

    const std::set<Key> whole = keys(some.transitions(by_matrix));
    const std::set<Key> found = keys(some.transitions(by_index));

    RC_ASSERT(std::ranges::includes(whole, found));
    RC_ASSERT(100 * (found.size() + 2) >=
              98 * whole.size());  // and one meeting, where there are few
  }));
}

TEST(Transitions, FoundByIndexAreTheSameForAnyNumberOfThreads) {
  const Studied shipped = all_shipped();
  const std::vector<Transition> alone = shipped.transitions(by_index, 1);
  for (const unsigned jobs : {2U, 5U}) {
    const std::vector<Transition> shared = shipped.transitions(by_index, jobs);

    EXPECT_TRUE(std::ranges::equal(alone, shared, [](const Transition& a, const Transition& b) {
      return a.from.clip == b.from.clip && a.from.frame == b.from.frame && a.to.clip == b.to.clip &&
             a.to.frame == b.to.frame && a.distance == b.distance &&
             a.alignment.heading == b.alignment.heading;
    }));
  }
}

TEST(Transitions, AreTheClosestThatLeaveInAWindow) {
  const Studied shipped = all_shipped();
  motion::offline::TransitionOptions few = by_matrix;
  few.per_window = 2;
  const auto by_window = [](const std::vector<Transition>& transitions) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<float>> windows;
    for (const Transition& t : transitions)
      windows[{t.from.clip, t.from.frame / 18}].push_back(t.distance);
    for (auto& [window, distances] : windows) std::ranges::sort(distances);
    return windows;
  };

  const auto all = by_window(shipped.transitions(by_matrix));
  const auto kept = by_window(shipped.transitions(few));

  ASSERT_EQ(all.size(), kept.size());
  std::size_t cut = 0;
  for (const auto& [window, distances] : all) {
    const std::vector<float>& closest = kept.at(window);
    ASSERT_EQ(closest.size(), std::min<std::size_t>(2, distances.size()));
    for (std::size_t i = 0; i < closest.size(); ++i) EXPECT_NEAR(closest[i], distances[i], 1e-4);
    cut += distances.size() > 2;
  }
  EXPECT_GT(cut, 20U);
}

}  // namespace
}  // namespace docent::test::alike_tiles_test
