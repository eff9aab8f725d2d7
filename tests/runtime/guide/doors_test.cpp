#include "runtime/guide/doors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/sample_as_read.h"

namespace docent::guide::doors_test {
namespace {

/// One of the sample museum's doors, hung and opened in some way, and places on either side of it.
struct Doorway {
  Museum museum;
  std::uint32_t floor = 0, door = 0;
  [[nodiscard]] const Door& it() const { return museum.floors[floor].plan.doors[door]; }
  /// `metres` from the door (to the left of its line: positive) and `along` it from its middle.
  [[nodiscard]] Placement place(double metres, double along, double towards) const {
    const Vec2 run = (it().b - it().a) / glm::distance(it().a, it().b);
    const Vec2 left{-run.y, run.x};
    const Vec2 heading = towards * left;
    return {0.5 * (it().a + it().b) + metres * left + along * run,
            std::atan2(heading.y, heading.x)};
  }
};

Doorway doorway(DoorOpens opens, DoorHinge hinge = DoorHinge::Both, double width = 2) {
  Doorway it{test::sample_museum(), test::sample_museum().kiosk_floor, 0};
  Door& door = it.museum.floors[it.floor].plan.doors[0];
  const Vec2 middle = 0.5 * (door.a + door.b), half = width / 2 * glm::normalize(door.b - door.a);
  door.a = middle - half;
  door.b = middle + half;
  door.opens = opens;
  door.hinge = hinge;
  return it;
}

/// What was seen of somebody who walked through.
struct Passage {
  double farthest_hand = 0;     ///< Metres from a handle whose leaf was turned, ...
  double turned_by_itself = 0;  ///< ... radians that a leaf turned open without one.
  double nearest = 1e9;         ///< Metres between bones and leaves, less their thickness.
  double most_open = 0;         ///< Radians.
  double held_seconds = 0;
  double hardest = 0;  ///< The largest change of a leaf's rate between two frames.
  bool arrived = false;
};

/// Half the thickness of what is about a joint, metres, as capsules.
constexpr double thickness_of_bones = 0.08;

double distance_to_bones(const Avatar& avatar, const Skeleton& skeleton, const Leaf& leaf,
                         const std::vector<bool>& is_arm) {
  double nearest = 1e9;
  for (std::size_t j = 1; j < skeleton.joint.size(); ++j) {
    const JointIndex parent = skeleton.joint[j].parent;
    if (parent == JointIndex::None || is_arm[j]) continue;
    const Vec3 a(avatar.world[index_of(parent)][3]), b(avatar.world[j][3]);
    for (int i = 0; i <= 4; ++i) {
      const Vec3 at = glm::mix(a, b, static_cast<float>(i) / 4);
      HungLeaf hung = leaf.hung;
      hung.hinge -= leaf.slid * hung.along;
      nearest = std::min(nearest, distance_to_leaf(hung, leaf.angle, to_floor(at)));
    }
  }
  return nearest - thickness_of_bones;
}

std::vector<bool> arms_of(const Skeleton& skeleton, const motion::Arms& arms) {
  std::vector<bool> is_arm(skeleton.joint.size());
  for (const Side side : both_sides)
    for (std::size_t i = arms[side]->elbow; i < arms[side]->count; ++i)
      is_arm[arms[side]->joint[i]] = true;
  for (std::size_t j = 1; j < is_arm.size(); ++j)
    if (skeleton.joint[j].parent != JointIndex::None && is_arm[index_of(skeleton.joint[j].parent)])
      is_arm[j] = true;
  return is_arm;
}

class Walker {
 public:
  explicit Walker(const Doorway& doorway, std::size_t agents = 1)
      : doorway_(doorway),
        planner_(doorway.museum, {}, agents),
        doors(doorway.museum),
        crowd(doorway.museum, planner_) {}

  std::uint32_t enters(const Placement& at) { return crowd.add(doorway_.floor, at, 100, 1); }

  /// Steps until it has arrived.
  Passage walk(std::uint32_t who, const Placement& to, double frame = 1.0 / 60,
               double patience = 30) {
    Passage seen;
    crowd.send(who, doorway_.floor, to, RouteKind::Shortest);
    for (double time = 0; time < patience && !seen.arrived; time += frame) {
      step(who, frame, seen);
      seen.arrived = crowd[who].has_arrived;
    }
    return seen;
  }

  void step(std::uint32_t who, double frame, Passage& seen) {
    std::vector<double> before, rate;
    for (const Leaf& leaf : doors.leaves()) before.push_back(leaf.angle);
    planner_.wait();
    doors.step(frame, crowd);
    crowd.step(frame);
    const Avatar& avatar = crowd[who].avatar;
    const Skeleton& skeleton = doorway_.museum.motion.skeleton;
    const std::vector<bool> is_arm = arms_of(skeleton, avatar.limbs.arms);
    rates_.resize(before.size());
    if (holds(avatar.manner)) seen.held_seconds += frame;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Leaf& leaf = doors.leaves()[i];
      const double opened = std::abs(leaf.angle) - std::abs(before[i]);
      seen.most_open = std::max(seen.most_open, std::abs(leaf.angle));
      seen.nearest = std::min(seen.nearest, distance_to_bones(avatar, skeleton, leaf, is_arm));
      seen.hardest = std::max(seen.hardest, std::abs(opened / frame - rates_[i]) / frame);
      rates_[i] = opened / frame;
      if (opened < 1e-5) continue;
      const auto& push = leaf.push;
      if (!push || !push->grasp)
        seen.turned_by_itself += opened;
      else
        seen.farthest_hand = std::max(seen.farthest_hand, distance_to_handle(avatar, leaf));
    }
  }

 private:
  double distance_to_handle(const Avatar& avatar, const Leaf& leaf) const {
    const motion::Arm& arm = *avatar.limbs.arms[leaf.push->grasp->side];
    const Mat4& wrist = avatar.world[arm.joint[arm.wrist]];
    const Vec3 out(sign_of(arm.side), 0, 0);
    const Vec3 palm = Vec3(wrist[3]) + glm::mat3(wrist) * (arm.rest[2] * out * (0.5F * arm.hand));
    const double height = doorway_.museum.floors[leaf.floor].plan.height;
    return glm::distance(palm, grip_of(leaf, *leaf.push, height).place);
  }

  const Doorway& doorway_;
  plan::Planner planner_;
  std::vector<double> rates_;

 public:
  Doors doors;
  Crowd crowd;
};

void expect_opened_by_hand(const Passage& seen) {
  EXPECT_TRUE(seen.arrived);
  EXPECT_GT(seen.most_open, 0.4);
  EXPECT_LE(seen.farthest_hand, 0.02);
  EXPECT_LT(seen.turned_by_itself, 1e-3);
  EXPECT_GT(seen.nearest, 0);
}

TEST(ADoor, IsPushedWithAHandOnItsBarWhileItTurnsAtAnyFrameRate) {
  for (const DoorHinge hinge : {DoorHinge::Both, DoorHinge::A, DoorHinge::B})
    for (const double side : {-1.0, 1.0})
      for (const double rate : {30.0, 60.0, 120.0}) {
        const Doorway it = doorway(DoorOpens::Push, hinge, hinge == DoorHinge::Both ? 2 : 1.1);
        Walker walker(it);
        const std::uint32_t who = walker.enters(it.place(3 * side, 0, -side));
        const Passage seen = walker.walk(who, it.place(-2.5 * side, 0, -side), 1 / rate);
        expect_opened_by_hand(seen);
      }
}

TEST(ADoor, IsPushedWhereverOneGoesThroughIt) {
  for (const double width : {2.0, 1.1})
    for (const double along : {-0.2, -0.1, 0.0, 0.1, 0.2})
      for (const double from : {0.0, 0.5}) {
        const Doorway it =
            doorway(DoorOpens::Push, width > 1.5 ? DoorHinge::Both : DoorHinge::A, width);
        const double scale = width / 2;
        Walker walker(it);
        const std::uint32_t who = walker.enters(it.place(-3, scale * (along + from), 1));
        const Passage seen = walker.walk(who, it.place(2.5, scale * along, 1));
        expect_opened_by_hand(seen);
      }
}

TEST(ADoor, IsFoundOpenByWhoComesNextAndClosesOnceNobodyIsNear) {
  const Doorway it = doorway(DoorOpens::Push);
  Walker walker(it);
  const std::uint32_t who = walker.enters(it.place(-3, 0, 1));
  walker.walk(who, it.place(2.5, 0, 1));
  const Passage back = walker.walk(who, it.place(-3.5, 0, -1));
  EXPECT_TRUE(back.arrived);
  EXPECT_EQ(back.held_seconds, 0);
  EXPECT_GT(back.nearest, 0);

  Passage later;
  for (int i = 0; i < 60 * 12; ++i) walker.step(who, 1.0 / 60, later);
  for (const Leaf& leaf : walker.doors.leaves()) EXPECT_EQ(leaf.angle, 0);
}

TEST(ADoor, ThatSlidesOrComesTowardsTheGuideIsOpenBeforeItIsReached) {
  for (const DoorOpens opens : {DoorOpens::Pull, DoorOpens::Sliding})
    for (const double side : {-1.0, 1.0}) {
      const Doorway it = doorway(opens);
      Walker walker(it);
      const std::uint32_t who = walker.enters(it.place(3.5 * side, 0, -side));
      const Passage seen = walker.walk(who, it.place(-2.5 * side, 0, -side));
      EXPECT_TRUE(seen.arrived);
      EXPECT_GT(seen.nearest, 0);
      if (opens == DoorOpens::Pull && side > 0) expect_opened_by_hand(seen);
    }
}

TEST(ADoor, LetsThroughWhoBeginsRightBeforeIt) {
  for (const DoorHinge hinge : {DoorHinge::Both, DoorHinge::A})
    for (const double metres : {0.5, 0.3, 0.2, 0.1, 0.05, 0.01})
      for (const double along : {-0.3, 0.0, 0.3}) {
        const Doorway it = doorway(DoorOpens::Push, hinge, hinge == DoorHinge::Both ? 2 : 1.1);
        Walker walker(it);
        const std::uint32_t who = walker.enters(it.place(-metres, along, 1));
        EXPECT_TRUE(walker.walk(who, it.place(2.5, 0, 1)).arrived) << metres << ", " << along;
      }
}

TEST(ADoor, IsPassedInItsMiddleByTheShortestWayToo) {
  const Doorway it = doorway(DoorOpens::Push);
  Walker walker(it);
  const std::uint32_t who = walker.enters(it.place(-2.5, 0.5, 1));
  walker.crowd.send(who, it.floor, it.place(2.5, 1.5, 1), RouteKind::Shortest);
  Passage seen;
  double nearest_to_middle = 1e9;
  const Vec2 middle = 0.5 * (it.it().a + it.it().b);
  for (int i = 0; i < 60 * 15; ++i) {
    walker.step(who, 1.0 / 60, seen);
    nearest_to_middle =
        std::min(nearest_to_middle, glm::distance(walker.crowd[who].avatar.body.position, middle));
  }
  EXPECT_LT(nearest_to_middle, 0.05);
  EXPECT_LE(seen.farthest_hand, 0.02);
  EXPECT_LT(seen.turned_by_itself, 1e-3);
  EXPECT_GT(seen.nearest, 0);
}

TEST(ADoor, SlowsWhoComesToIt) {
  const auto seconds_through = [](DoorOpens opens) {
    const Doorway it = doorway(opens);
    Walker walker(it);
    const std::uint32_t who = walker.enters(it.place(-3, 0, 1));
    walker.walk(who, it.place(2.5, 0, 1));
    return walker.crowd.clock();
  };
  const double open = seconds_through(DoorOpens::None), leaf = seconds_through(DoorOpens::Push);
  EXPECT_GT(leaf, open + 0.5);
  EXPECT_LT(leaf, open + 3);
}

}  // namespace
}  // namespace docent::guide::doors_test
