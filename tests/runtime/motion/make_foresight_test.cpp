#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "runtime/motion/make_foresight.h"
#include "runtime/motion/passages.h"
#include "runtime/motion/search.h"
#include "tests/runtime/motion/hand_made_graph.h"

namespace docent::motion::make_foresight_test {
namespace {

constexpr std::size_t straight = bend_axis.count / 2;

/// Every fifth transition is enough, and the bends of the track below: straight on and to the left.
MotionGraph with_foresight() {
  MotionGraph motion = test::hand_made_graph();
  std::vector<Transition> few;
  for (std::size_t t = 0; t < motion.transitions.size(); t += 5)
    few.push_back(motion.transitions[t]);
  motion.transitions = few;
  Foresight foresight;
  {
    const WalkGraph graph = *make_walk_graph(motion);
    foresight = begin_foresight(graph);
    for (std::size_t bend = straight; bend < straight + 4; ++bend) add_bend(graph, bend, foresight);
  }
  motion.foresight = std::move(foresight);
  return motion;
}

const MotionGraph& motion() {
  static const MotionGraph motion = with_foresight();
  return motion;
}
const WalkGraph& graph() {
  static const WalkGraph graph = *make_walk_graph(motion());
  return graph;
}

const std::uint16_t* raw_slice_of(std::size_t transition, std::size_t bend) {
  return &motion().foresight.raw[(transition * bend_axis.count + bend) * raw_slice];
}

bool leads_to_a_stand(std::size_t transition) {
  return motion().clips[motion().transitions[transition].to.clip].role == ClipRole::Stop;
}

/// Those after which one can walk on for a while.
std::vector<std::size_t> lasting_transitions() {
  std::vector<std::size_t> lasting;
  for (std::size_t t = 0; t < motion().transitions.size(); ++t)
    if (Foresight::unit * foreseen_raw(raw_slice_of(t, straight), 0, 0) < 1) lasting.push_back(t);
  return lasting;
}

/// Of those the ones that lead into the first half of the straight walk.
std::vector<std::size_t> straight_transitions() {
  std::vector<std::size_t> going = lasting_transitions();
  std::erase_if(going, [](std::size_t t) {
    const ClipFrame to = motion().transitions[t].to;
    const MotionClip& clip = motion().clips[to.clip];
    return clip.role != ClipRole::Walk || to.frame > frame_count(clip) / 2;
  });
  return going;
}

TEST(GridAxis, FindsEachOfItsValuesAgain) {
  for (const GridAxis& axis : {bend_axis, turn_axis, side_axis, room_axis})
    for (std::size_t i = 0; i < axis.count; ++i) {
      const auto [low, share] = axis.place(axis.value(i));
      EXPECT_NEAR(static_cast<double>(low) + share, static_cast<double>(i), 1e-9);
    }
}

TEST(GridAxis, HoldsOnToItsEnds) {
  EXPECT_EQ(turn_axis.place(-1e9).low, 0u);
  EXPECT_EQ(turn_axis.place(1e9).low, turn_axis.count - 2);
  EXPECT_EQ(turn_axis.place(1e9).share, 1.0);
}

TEST(Foresight, ExpectsLeastOfABodyThatIsOnItsTrack) {
  EXPECT_GT(straight_transitions().size(), 10u);
  for (const std::size_t t : straight_transitions()) {
    const std::uint16_t* slice = raw_slice_of(t, straight);
    const double on_track = foreseen_raw(slice, 0, 0);
    for (const double side : {-0.3, 0.3}) EXPECT_GT(foreseen_raw(slice, side, 0), on_track) << t;
  }
}

TEST(Foresight, PrefersToFaceBackToTheTrack) {
  for (const std::size_t t : straight_transitions()) {
    const std::uint16_t* slice = raw_slice_of(t, straight);
    EXPECT_LT(foreseen_raw(slice, 0.2, -0.2), foreseen_raw(slice, 0.2, 0.2)) << t;
  }
}

TEST(Foresight, DoesNotExpectToWalkOnAfterAStand) {
  const std::vector<std::size_t> lasting = lasting_transitions();
  EXPECT_GT(lasting.size(), motion().transitions.size() / 2);
  for (const std::size_t t : lasting) EXPECT_FALSE(leads_to_a_stand(t)) << t;
}

/// By trying all walks of up to `passages` passages.
double nearest_stand(std::uint32_t transition, double room, int passages) {
  const ClipFrame at = motion().transitions[transition].to;
  const ClipPath& clip = graph().clip[at.clip];
  double least = std::numeric_limits<double>::infinity();
  if (motion().clips[at.clip].role == ClipRole::Stop && at.frame <= clip.last)
    least = std::abs(room - (clip.effort[clip.last] - clip.effort[at.frame]));
  if (passages == 0 || room < -1) return least;
  double walked = 0;
  walk_from_transition(
      graph(), Choice{0}, transition,
      [&](std::size_t from, std::size_t to) { walked += clip.effort[to] - clip.effort[from]; },
      [&](std::uint32_t next) {
        least = std::min(least, nearest_stand(next, room - walked, passages - 1));
      });
  return least;
}

TEST(Foresight, KnowsByHowMuchTheNearestStandMissesTheEnd) {
  for (std::uint32_t t = 0; t < motion().transitions.size(); ++t)
    for (const std::size_t room : {15u, 20u, 25u}) {
      const double known = Foresight::unit * motion().foresight.ending[t * room_axis.count + room];
      const double tried = std::min(nearest_stand(t, room_axis.value(room), 3), 2.0);
      // Between two values of the axis the table is a straight line, and it does not tell by how
      // much a walk misses the end that goes more than a metre beyond it.
      if (tried > 1) {
        EXPECT_GT(known, 1 - room_axis.step) << t << " " << room;
      } else {
        EXPECT_NEAR(known, tried, room_axis.step + 1e-3) << t << " " << room;
      }
    }
}

PathTrack bent_track() {
  std::vector<Vec2> path;
  for (int i = 0; i <= 200; ++i) {
    const double a = 0.01 * i * 3.14159;
    path.emplace_back(4 * std::sin(a), 4 * (1 - std::cos(a)));
  }
  return make_path_track(path, {.speed = graph().speed, .turning_rate = 1e9});
}

TEST(Foresight, MakesTheSearchFindNoWorseWays) {
  MotionGraph blind = motion();
  blind.foresight = {};
  const WalkGraph without = *make_walk_graph(blind);
  const std::uint32_t clip = graph().starts.front();
  const std::array start{MotionStart{{clip, graph().clip[clip].first}, {Vec2{0, 0}, 0}}};

  const MotionPlan foreseen = find_raw_motion(graph(), bent_track(), start);
  const MotionPlan groped = find_raw_motion(without, bent_track(), start);

  EXPECT_GT(foreseen.expanded, 0u);
  EXPECT_LE(foreseen.cost, 1.02 * groped.cost);
}

}  // namespace
}  // namespace docent::motion::make_foresight_test
