// The guide takes the stairs, with the clips that ship.
#include "runtime/motion/climb.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "runtime/motion/leg.h"
#include "runtime/motion/walk_graph.h"
#include "tests/support/sample_as_read.h"

namespace docent::motion::climb_test {
namespace {

const WalkGraph& graph() {
  static const WalkGraph ready = *make_walk_graph(test::sample_museum().motion);
  return ready;
}

/// A flight as it is built: steps of 13 to 17 cm, each 25 to 36 cm deep.
Ascent flight(double rise, double depth, double before = 0.45, double after = 0.45) {
  Ascent ascent;
  ascent.from = {3, -2};
  ascent.treads = {.near = before,
                   .length = 0,
                   .rise = rise,
                   .count = std::max(1, static_cast<int>(std::ceil(std::abs(rise) / 0.17 - 1e-9)))};
  ascent.treads.length = depth * ascent.treads.count;
  ascent.to = ascent.from + Vec2{0.6, 0.8} * (before + ascent.treads.length + after);
  return ascent;
}

Placement start_of(const Ascent& ascent) {
  const Vec2 way = ascent.to - ascent.from;
  return {ascent.from, std::atan2(way.y, way.x)};
}

/// What somebody sees who looks at feet.
struct Seen {
  double off_tread = 0;  ///< A planted foot's height over or under its tread, metres.
  double slides = 0;     ///< Of a planted foot while it is planted, metres.
  double sinks = 0;      ///< Of ball, tip or heel under what is below it, metres.
  double least_knee = 9, most_knee = 0, most_hip = 0;  ///< Flexion, radians.
  double quickest_rise = 0;                            ///< Of the body, metres a second.
  double hardest_rise = 0;                             ///< Metres a second squared, over 50 ms.
  double quickest_toe = 0;                             ///< Metres a second.
  double misses = 0;  ///< Of the body at the end: metres, height included.
};

class Watcher {
 public:
  Watcher(const Ascent& ascent, const Walk& walk) : ascent_(ascent), walk_(walk) {
    along_ = (ascent.to - ascent.from) / glm::distance(ascent.from, ascent.to);
    rotation_.resize(walk.joint_count);
  }

  Seen watch() {
    for (std::size_t f = 0; f < walk_.root.size(); ++f) watch_frame(f);
    const auto height = [&](std::size_t f) { return walk_.root[f].y + walk_.climb[f].body; };
    const std::size_t step = 6;
    for (std::size_t f = 0; f + 2 * step < walk_.root.size(); ++f) {
      const double a = height(f), b = height(f + step), c = height(f + 2 * step);
      const double seconds = static_cast<double>(step) / walk_.frame_rate;
      seen_.quickest_rise = std::max(seen_.quickest_rise, std::abs(b - a) / seconds);
      seen_.hardest_rise =
          std::max(seen_.hardest_rise, std::abs(a - 2 * b + c) / seconds / seconds);
    }
    seen_.misses = std::max(glm::distance(walk_.body.back().position, ascent_.to),
                            std::abs(walk_.climb.back().body - ascent_.treads.rise));
    return seen_;
  }

 private:
  double ground_at(Vec3 place) const {
    return ascent_.treads.height_at(dot(to_floor(place) - ascent_.from, along_));
  }

  void watch_frame(std::size_t f) {
    PoseView pose{.root = {}, .rotation = rotation_};
    sample(walk_, static_cast<double>(f) / walk_.frame_rate, pose);
    pose.root.y += walk_.climb[f].body;
    for (const Side side : both_sides) {
      const std::size_t s = index_of(side);
      const Leg& leg = graph().legs[side];
      const LegPose at = leg_pose(test::sample_museum().motion.skeleton, leg, pose);
      const Vec3 toe = at.position[leg.toe], ankle = at.position[leg.ankle];
      const double ball = toe.y - graph().toe_height[s];
      const bool planted = s == 0 ? walk_.plants[f].left : walk_.plants[f].right;
      if (!planted) planted_[s].reset();
      if (planted && !planted_[s]) planted_[s] = toe;
      if (planted) {
        seen_.slides = std::max<double>(seen_.slides, glm::distance(toe, *planted_[s]));
        seen_.off_tread = std::max(seen_.off_tread, std::abs(ball - ground_at(toe)));
      }
      const Vec3 tip = toe + to_world(along_ * double(glm::length(leg.tip)));
      const Vec3 heel = ankle - to_world(along_ * 0.04);  // of a tilted foot nearly so
      seen_.sinks = std::max({seen_.sinks, ground_at(toe) - ball, ground_at(tip) - ball,
                              ground_at(heel) - (ankle.y - graph().ankle_height[s]) - 0.007});
      watch_joints(at, leg);
      if (before_[s])
        seen_.quickest_toe =
            std::max(seen_.quickest_toe, glm::distance(toe, *before_[s]) * walk_.frame_rate);
      before_[s] = toe;
    }
  }

  void watch_joints(const LegPose& at, const Leg& leg) {
    const Vec3 thigh = glm::normalize(at.position[leg.knee] - at.position[leg.hip]);
    const Vec3 shin = glm::normalize(at.position[leg.ankle] - at.position[leg.knee]);
    const double knee = std::acos(std::clamp(glm::dot(thigh, shin), -1.0F, 1.0F));
    const Vec3 left = at.rotation[leg.hip] * leg.body_left;
    const double backwards = glm::dot(glm::cross(thigh, shin), left) < 0 ? -1 : 1;
    seen_.least_knee = std::min(seen_.least_knee, backwards * knee);
    seen_.most_knee = std::max(seen_.most_knee, knee);
    const double ahead = dot(to_floor(thigh), along_);
    seen_.most_hip = std::max(seen_.most_hip, std::abs(std::atan2(ahead, -double(thigh.y))));
  }

  const Ascent& ascent_;
  const Walk& walk_;
  Vec2 along_{};
  std::vector<Quat> rotation_;
  std::array<std::optional<Vec3>, 2> planted_, before_;
  Seen seen_;
};

std::optional<Walk> climbed(const Ascent& ascent) {
  WalkRequest request;
  request.start = start_of(ascent);
  request.final_heading = request.start->heading;
  Result<Walk> walk = climb(graph(), ascent, request);
  if (!walk) return std::nullopt;
  return std::move(*walk);
}

std::ostream& operator<<(std::ostream& out, const Seen& s) {
  return out << "off tread " << s.off_tread << ", slides " << s.slides << ", sinks " << s.sinks
             << ", knee " << s.least_knee << " to " << s.most_knee << ", hip " << s.most_hip
             << ", rises at " << s.quickest_rise << " m/s, " << s.hardest_rise << " m/s2, toe "
             << s.quickest_toe << " m/s, misses " << s.misses;
}

void expect_human(const Seen& seen) {
  EXPECT_LT(seen.off_tread, 0.005);
  EXPECT_LT(seen.slides, 0.005);
  EXPECT_LT(seen.sinks, 0.005);
  EXPECT_GT(seen.least_knee, -0.03);
  EXPECT_LT(seen.most_knee, 2.35);
  EXPECT_LT(seen.most_hip, 1.9);
  EXPECT_LT(seen.quickest_rise, 1.1);
  EXPECT_LT(seen.hardest_rise, 12);
  EXPECT_LT(seen.quickest_toe, 5);
  EXPECT_LT(seen.misses, 0.02);
}

class Stairs : public testing::TestWithParam<double> {};

TEST_P(Stairs, AreTakenStepByStepWithAFootOnEachTread) {
  const Ascent ascent = flight(GetParam(), 0.29);
  const auto walk = climbed(ascent);

  ASSERT_TRUE(walk);
  const Seen seen = Watcher(ascent, *walk).watch();
  expect_human(seen);
  std::cout << "rise " << GetParam() << " m in " << double(walk->root.size()) / walk->frame_rate
            << " s: " << seen << "\n";
}

INSTANTIATE_TEST_SUITE_P(UpAndDown, Stairs,
                         testing::Values(0.1, 0.5, 1, 4, 6, -0.1, -0.5, -1, -4, -6));

TEST(Climb, HoldsOnAnyFlightThatIsBuilt) {
  EXPECT_TRUE(rc::check("feet are on treads, still, and above them", [] {
    const double rise = *rc::gen::inRange(10, 600) / 100.0 * *rc::gen::element(1, -1);
    const double depth = *rc::gen::inRange(25, 37) / 100.0;
    const Ascent ascent =
        flight(rise, depth, *rc::gen::inRange(35, 110) / 100.0, *rc::gen::inRange(35, 110) / 100.0);
    const auto walk = climbed(ascent);
    RC_ASSERT(walk.has_value());
    const Seen seen = Watcher(ascent, *walk).watch();
    RC_LOG() << rise << " m, " << depth << ": " << seen << "\n";
    RC_ASSERT(seen.off_tread < 0.005);
    RC_ASSERT(seen.slides < 0.005);
    RC_ASSERT(seen.sinks < 0.005);
    RC_ASSERT(seen.least_knee > -0.03);
    RC_ASSERT(seen.most_knee < 2.35);
    RC_ASSERT(seen.most_hip < 1.9);
    RC_ASSERT(seen.quickest_rise < 1.1);
    RC_ASSERT(seen.hardest_rise < 12);
    RC_ASSERT(seen.misses < 0.02);
  }));
}

TEST(Climb, TakesAStepInHalfASecondToOneAsPeopleDo) {
  const Ascent ascent = flight(4, 0.29);
  const auto walk = climbed(ascent);

  ASSERT_TRUE(walk);
  const double seconds = static_cast<double>(walk->root.size()) / walk->frame_rate;
  EXPECT_GT(seconds / ascent.treads.count, 0.45);
  EXPECT_LT(seconds / ascent.treads.count, 0.85);
}

}  // namespace
}  // namespace docent::motion::climb_test
