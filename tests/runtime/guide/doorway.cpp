#include "tests/runtime/guide/doorway.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/scene/leaf_mesh.h"
#include "tests/runtime/path/floors.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::test {
namespace {

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

bool is_elbow_or_wrist(const Avatar& avatar, std::size_t joint) {
  return std::ranges::any_of(both_sides, [&](Side side) {
    const motion::Arm& arm = *avatar.limbs.arms[side];
    return joint == arm.joint[arm.elbow] || joint == arm.joint[arm.wrist];
  });
}

}  // namespace

double amount_of(const Leaf& leaf) {
  return leaf.opens == DoorOpens::Sliding ? leaf.slid : std::abs(leaf.angle);
}

Placement Doorway::place(double metres, double along, double towards) const {
  const Vec2 run = (it().b - it().a) / glm::distance(it().a, it().b);
  const Vec2 left{-run.y, run.x};
  const Vec2 heading = towards * left;
  return {0.5 * (it().a + it().b) + metres * left + along * run, std::atan2(heading.y, heading.x)};
}

Doorway doorway(DoorOpens opens, DoorHinge hinge, double width) {
  Doorway it{docent::test::sample_museum(), docent::test::sample_museum().kiosk_floor, 0};
  Door& door = it.museum.floors[it.floor].plan.doors[0];
  const Vec2 middle = 0.5 * (door.a + door.b), half = width / 2 * glm::normalize(door.b - door.a);
  door.a = middle - half;
  door.b = middle + half;
  door.opens = opens;
  door.hinge = hinge;
  return it;
}

Doorway walled_doorway(DoorOpens opens, DoorHinge hinge, double width, const Beside& beside) {
  constexpr double room = 6, wall = 0.2;
  const double low = beside.a, high = low + width, top = high + beside.b, far = 2 * room + wall;
  const import::ImportedPlan plan = docent::test::drawn({{0, 0},
                                                         {room, 0},
                                                         {room, low},
                                                         {room + wall, low},
                                                         {room + wall, 0},
                                                         {far, 0},
                                                         {far, top},
                                                         {room + wall, top},
                                                         {room + wall, high},
                                                         {room, high},
                                                         {room, top},
                                                         {0, top}});
  Doorway it;
  it.museum.motion = docent::test::sample_museum().motion;
  it.museum.avatar = docent::test::sample_museum().avatar;
  const double radius = it.museum.body_radius;
  it.museum.floors.push_back(docent::test::floor_of(plan, {radius + Museum::walking_room, radius}));
  it.museum.floors[0].plan.doors.push_back({.name = "door",
                                            .a = {room + wall / 2, low},
                                            .b = {room + wall / 2, high},
                                            .opens = opens,
                                            .hinge = hinge});
  return it;
}

Walker::Walker(const Doorway& doorway, std::size_t agents)
    : doorway_(doorway),
      planner_(doorway.museum, {}, agents),
      doors(doorway.museum),
      crowd(doorway.museum, planner_) {}

Passage Walker::walk(std::uint32_t who, const Placement& to, double frame, double patience) {
  Passage seen;
  crowd.send(who, doorway_.floor, to, RouteKind::Shortest);
  for (; seen.seconds < patience && !seen.arrived; seen.seconds += frame) {
    step(who, frame, seen);
    seen.arrived = crowd[who].has_arrived;
  }
  return seen;
}

void Walker::step(std::uint32_t who, double frame, Passage& seen) {
  std::vector<double> before;
  for (const Leaf& leaf : doors.leaves()) before.push_back(amount_of(leaf));
  planner_.wait();
  doors.step(frame, crowd);
  crowd.step(frame);
  const Avatar& avatar = crowd[who].avatar;
  const Skeleton& skeleton = doorway_.museum.motion.skeleton;
  const std::vector<bool> is_arm = arms_of(skeleton, avatar.limbs.arms);
  rates_.resize(before.size());
  const auto& held = avatar.manner.held;
  const bool holds =
      (held[0] || held[1]) && std::ranges::none_of(doors.leaves(), [](const Leaf& leaf) {
        return leaf.drawing && leaf.drawing->parts > 0;
      });
  if (holds) seen.held_seconds += frame;
  look_at_feet(avatar, seen);
  look_at_arms(avatar, is_arm, frame, seen);
  double nearest_bar = 1e9, moved = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Leaf& leaf = doors.leaves()[i];
    const double opened = amount_of(leaf) - before[i];
    seen.most_open = std::max(seen.most_open, amount_of(leaf));
    seen.nearest = std::min(seen.nearest, distance_to_bones(avatar, skeleton, leaf, is_arm));
    seen.hardest = std::max(seen.hardest, std::abs(opened / frame - rates_[i]) / frame);
    rates_[i] = opened / frame;
    if (opened < 1e-5) continue;
    if (leaf.push && leaf.push->grasp && !is_pushed_by_hand(leaf)) seen.ahead_of_hand += opened;
    if (!holds) {
      seen.turned_by_itself += opened;
      if (seen.by_hand == 0) seen.before_hand += opened;
      continue;
    }
    // Of two that slide together, the hand is on one.
    const double off = palm_to_bar(avatar, held[0] ? Side{0} : Side{1}, leaf);
    if (off > nearest_bar) continue;
    nearest_bar = off;
    moved = opened;
  }
  if (moved == 0) return;
  seen.farthest_hand = std::max(seen.farthest_hand, nearest_bar);
  seen.by_hand += moved;
}

bool Walker::is_pushed_by_hand(const Leaf& leaf) const {
  const Avatar& avatar = crowd[leaf.push->who].avatar;
  return palm_to_bar(avatar, leaf.push->grasp->side, leaf) <= 0.02;
}

/// From the middle of the palm to the surface of the bar, on the side where the palm is.
double Walker::palm_to_bar(const Avatar& avatar, Side side, const Leaf& leaf) const {
  const motion::Arm& arm = *avatar.limbs.arms[side];
  const Mat4& wrist = avatar.world[arm.joint[arm.wrist]];
  const Vec3 out(sign_of(arm.side), 0, 0);
  const Vec3 palm = Vec3(wrist[3]) + glm::mat3(wrist) * (arm.rest[2] * out * (0.5F * arm.hand));
  const double height = doorway_.museum.floors[leaf.floor].plan.height + scene::bar_height;
  const Vec2 from = to_floor(palm) - (leaf.hung.hinge - leaf.slid * leaf.hung.along);
  const Vec2 along = direction_of(leaf.hung, leaf.angle);
  const auto beyond = [](double at, double low, double high) {
    return std::max({0.0, low - at, at - high});
  };
  constexpr double half = scene::bar_thickness / 2;
  return std::hypot(
      beyond(dot(from, along), 0, leaf.hung.width),
      beyond(std::abs(cross(from, along)), scene::bar_surface - 2 * half, scene::bar_surface),
      beyond(static_cast<double>(palm.y), height - half, height + half));
}

/// Of elbows and wrists; the tips of fingers that are hooked over a bar may touch the board.
void Walker::look_at_arms(const Avatar& avatar, const std::vector<bool>& is_arm, double frame,
                          Passage& seen) {
  arm_side_.resize(doors.leaves().size() * is_arm.size());
  std::vector<Vec3> hands;
  for (std::size_t j = 0; j < is_arm.size(); ++j)
    if (is_arm[j]) hands.emplace_back(avatar.world[j][3]);
  if (hands_.size() == hands.size())
    for (std::size_t i = 0; i < hands.size(); ++i)
      seen.fastest_hand = std::max(seen.fastest_hand,
                                   static_cast<double>(glm::distance(hands[i], hands_[i])) / frame);
  hands_ = hands;
  std::size_t at = 0;
  for (const Leaf& leaf : doors.leaves())
    for (std::size_t j = 0; j < is_arm.size(); ++j, ++at) {
      const Vec2 from =
          to_floor(Vec3(avatar.world[j][3])) - leaf.hung.hinge + leaf.slid * leaf.hung.along;
      const Vec2 along = direction_of(leaf.hung, leaf.angle);
      const double beside = dot(from, along);
      const double side = is_elbow_or_wrist(avatar, j) && beside > 0 && beside < leaf.hung.width
                              ? cross(along, from)
                              : 0;
      if (side * arm_side_[at] < 0) seen.hand_went_through = true;
      arm_side_[at] = side;
    }
}

/// Only while it stands: who walks has feet that move.
void Walker::look_at_feet(const Avatar& avatar, Passage& seen) {
  if (!guide::holds(avatar.manner) || !stands(avatar)) return feet_.clear();
  std::vector<Vec3> now;
  for (const BodyPart part :
       {BodyPart::LeftAnkle, BodyPart::LeftToe, BodyPart::RightAnkle, BodyPart::RightToe})
    now.emplace_back(avatar.world[index_of(doorway_.museum.motion.skeleton[part])][3]);
  if (feet_.empty()) feet_ = now;
  for (std::size_t i = 0; i < now.size(); ++i)
    seen.feet_slid = std::max(seen.feet_slid, static_cast<double>(glm::distance(now[i], feet_[i])));
}

}  // namespace docent::guide::test
