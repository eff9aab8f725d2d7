// Flights of steps as the sample museum's guide takes them: where its feet are on every frame.
#include "runtime/motion/climb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <rapidcheck.h>

#include "platform/sqlite/content_reader.h"
#include "runtime/motion/pose.h"
#include "tests/support/sample_database.h"

namespace docent::motion {
namespace {

const WalkGraph& graph() {
  static const Museum museum = sqlite::load_museum(test::sample_database()).value();
  static const WalkGraph it = make_walk_graph(museum.motion).value();
  return it;
}

/// A flight from (1, 2) on, and what the guide makes of it.
struct Climbed {
  ClimbRequest request;
  Walk walk;
  double length = 0;
  Vec2 along{};

  double along_way(Vec3 place) const {
    return dot(Vec2(place.x, -place.z) - request.from, along);
  }
  /// How high the ground is there, and at the flight's far end beyond it.
  double ground(double at) const {
    const Treads& treads = request.treads;
    const auto tread = static_cast<int>(std::floor((at - treads.near) / treads.depth));
    if (tread < 0) return 0;
    return treads.height(std::min(tread, treads.count - 1));
  }
  /// The pose of a frame, above the floor where the flight begins.
  PoseView pose(std::size_t frame) {
    PoseView pose = {walk.root[frame],
                     std::span(walk.rotation).subspan(frame * walk.joint_count, walk.joint_count)};
    const Vec2 body = walk.body[frame].position;
    const double share = std::clamp(dot(body - request.from, along) / length, 0.0, 1.0);
    pose.root.y += static_cast<float>(share * request.treads.rise());
    return pose;
  }
};

Climbed climbed(double rise, double length, double direction, double facing) {
  Climbed it;
  it.along = {std::cos(direction), std::sin(direction)};
  it.length = length;
  const int count = steps_of(rise);
  it.request = {.treads = {.near = 0.6,
                           .depth = (length - 1.2) / count,
                           .count = count,
                           .riser = rise / count},
                .from = {1, 2},
                .to = Vec2{1, 2} + length * it.along,
                .start = {{1, 2}, facing},
                .final_heading = direction,
                .seconds = 1.8 * std::abs(rise) / 0.5};
  if (auto walk = make_climb(graph(), it.request)) it.walk = std::move(*walk);
  return it;
}

/// What is seen of a climb.
struct Seen {
  double off_tread = 0;    ///< Metres by which a planted ball is above or below its tread.
  double slide = 0;        ///< Metres by which a planted ball moves.
  double into_ground = 0;  ///< Metres by which a ball or a tip of toes is below the ground.
  double sink = 0;         ///< Metres by which a heel is.
  double speed = 0;        ///< Metres a second of the hips, up or down.
  double bend = 0;         ///< Degrees of a knee.
  int plants = 0;
};

Seen seen(Climbed& climb) {
  Seen all;
  const WalkGraph& g = graph();
  const Skeleton& skeleton = g.motion->skeleton;
  std::array<std::optional<Vec3>, 2> planted;
  double height_before = 0;
  for (std::size_t f = 0; f < climb.walk.root.size(); ++f) {
    PoseView pose = climb.pose(f);
    if (f > 0)
      all.speed = std::max(all.speed, std::abs(pose.root.y - height_before) * g.frame_rate);
    height_before = pose.root.y;
    for (const Side side : both_sides) {
      const std::size_t i = index_of(side);
      const Leg& leg = g.legs[side];
      const Foot foot = foot_of(skeleton, leg, pose);
      const double rest = g.after_walking.foot[i].toe.y;
      const double above = foot.toe.y - rest;
      const double at = climb.along_way(foot.toe);
      all.into_ground = std::max(all.into_ground, climb.ground(at) - above);
      const Vec3 forwards = foot.toe - ankle_of(leg, foot);
      const Vec3 flat = glm::normalize(Vec3(forwards.x, 0, forwards.z));
      all.into_ground =
          std::max(all.into_ground, climb.ground(climb.along_way(foot.toe + 0.06F * flat)) - above);
      const Vec3 ankle = ankle_of(leg, foot);
      all.sink = std::max(all.sink, climb.ground(climb.along_way(ankle)) -
                                        (ankle.y - g.ankle_height[i]));
      const LegPose posed = leg_pose(skeleton, leg, pose);
      const Vec3 thigh = posed.position[leg.hip] - posed.position[leg.knee];
      const Vec3 shin = posed.position[leg.ankle] - posed.position[leg.knee];
      const double cosine = glm::dot(glm::normalize(thigh), glm::normalize(shin));
      all.bend = std::max(
          all.bend, 180 - std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi);
      const bool stands = side == Side::Left ? climb.walk.plants[f].left : climb.walk.plants[f].right;
      if (!stands) {
        planted[i].reset();
        continue;
      }
      if (!planted[i]) ++all.plants;
      planted[i] = planted[i].value_or(foot.toe);
      all.off_tread = std::max(all.off_tread, std::abs(climb.ground(at) - above));
      all.slide = std::max(all.slide, static_cast<double>(glm::distance(*planted[i], foot.toe)));
    }
  }
  return all;
}

TEST(AClimb, SetsEveryFootOnATreadWhereItStaysUpAndDownAnyFlight) {
  EXPECT_TRUE(rc::check("feet", [] {
    const double rise = (*rc::gen::arbitrary<bool>() ? 1 : -1) * 0.001 * *rc::gen::inRange(150, 6001);
    const double slope = 0.001 * *rc::gen::inRange(420, 720);  // riser by tread
    const double length = 1.2 + std::abs(rise) / slope;
    const double direction = 0.01 * *rc::gen::inRange(-314, 315);
    Climbed climb = climbed(rise, length, direction, direction);
    RC_ASSERT(!climb.walk.root.empty());
    const Seen it = seen(climb);
    RC_LOG() << "rise " << rise << " slope " << slope << ": off " << it.off_tread << " slide "
             << it.slide << " into " << it.into_ground << " heel " << it.sink << " speed "
             << it.speed << " bend " << it.bend << " plants " << it.plants << "\n";
    RC_ASSERT(it.plants >= std::abs(rise) / 0.36);
    RC_ASSERT(it.off_tread < 0.005);
    RC_ASSERT(it.slide < 0.005);
    RC_ASSERT(it.into_ground < 0.005);
    RC_ASSERT(it.sink < 0.02);
    RC_ASSERT(it.speed < 1.2);
    RC_ASSERT(it.bend < 130);
    const Placement& end = climb.walk.body.back();
    RC_ASSERT(glm::distance(end.position, climb.request.to) < 0.02);
  }));
}

TEST(AClimb, BeginsAndEndsFacingAnywhere) {
  for (const double facing : {0.0, 1.5, -1.5, 3.1}) {
    Climbed climb = climbed(3.4, 7, 0.3, facing);
    const Seen it = seen(climb);
    EXPECT_LT(it.off_tread, 0.005) << facing;
    EXPECT_LT(it.slide, 0.005) << facing;
    EXPECT_NEAR(std::remainder(climb.walk.body.back().heading - 0.3, 2 * std::numbers::pi), 0, 0.1);
  }
}

TEST(AClimb, IsNotMadeOfALadder) {
  EXPECT_TRUE(climbed(4, 1.8, 0, 0).walk.root.empty());
}

}  // namespace
}  // namespace docent::motion
