#include "runtime/guide/door_stop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace docent::guide {
namespace {

constexpr double most_pulled = 1.2, most_slid = 0.9;         ///< Radians; metres.
constexpr double worth_pulling = 0.3, worth_sliding = 0.35;  ///< Radians; metres.
constexpr float to_spare = 0.02F;  ///< Metres that a hand must reach farther: who stands breathes.
constexpr int parts_of_way = 15;
/// Metres by which a palm may miss the bar, as planned and in the end.
constexpr float planned_off = 0.008F, most_off = 0.014F;
constexpr double thickness_of_arm = 0.04;  ///< Metres from its bones.
constexpr float trunk_sways = 0.12F;       ///< Of a trunk that stands, radians.

double most_of(const ClosedLeaf& leaf) noexcept {
  return leaf.slides ? std::min(most_slid, 0.9 * leaf.hung.width) : most_pulled;
}

/// The body there, bent at its waist.
Holder bent(const Holder& holder, const motion::TrunkBend& bend) noexcept {
  Holder there = holder;
  const Quat turn = motion::rotation_of(bend, holder.body.heading);
  for (motion::JointPlace& trunk : there.trunk)
    trunk = {holder.waist + turn * (trunk.place - holder.waist), turn * trunk.rotation};
  return there;
}

/// An arm that is to hold something, in the frame of a body whose trunk is turned a little.
struct Reach {
  motion::ArmPosture posture;
  motion::ArmPlaces places;
  float off = 0;  ///< Metres between the palm and what it is to hold.
};

/// `turned`: the trunk, radians; `farther`: what is held, metres.
Reach reach_for(const ClosedLeaf& leaf, const Holder& holder, Side side, motion::Grip grip,
                float turned, float farther) noexcept {
  const motion::Arm& arm = *holder.arms[side];
  const auto ground = static_cast<float>(leaf.floor_height);
  grip.place.y = ground + (grip.place.y - ground) / static_cast<float>(holder.height);
  motion::JointPlace trunk = holder.trunk[index_of(side)];
  trunk.rotation = glm::angleAxis(turned, Vec3(0, 1, 0)) * trunk.rotation;
  grip.place += farther * glm::normalize(grip.place - trunk.place);
  Reach reach{.posture = motion::holding(holder.skeleton, arm, trunk, grip), .places = {}};
  reach.places = motion::places_of(holder.skeleton, arm, trunk, reach.posture);
  reach.off = glm::distance(reach.places.palm, grip.place);
  return reach;
}

/// Is an arm before a leaf that is turned so, or past its free end, with so much room?
bool is_clear_of(const HungLeaf& leaf, double amount, const motion::ArmPlaces& arm,
                 double room = thickness_of_arm) noexcept {
  const Vec2 along = direction_of(leaf, amount);
  const Vec2 front = direction_of(leaf, amount + std::numbers::pi / 2);
  for (const Vec3& place : {arm.elbow, glm::mix(arm.elbow, arm.wrist, 0.35F),
                            glm::mix(arm.elbow, arm.wrist, 0.7F), arm.wrist, arm.palm}) {
    const Vec2 from = to_floor(place) - leaf.hinge;
    if (dot(from, along) < leaf.width + room && dot(from, front) < room) return false;
  }
  return true;
}

/// Are shoulders and head before a leaf, or past its free end?
bool is_trunk_clear_of(const ClosedLeaf& leaf, const Holder& holder, double amount) noexcept {
  constexpr double room = 0.2;  // metres
  if (leaf.slides) return true;
  return std::ranges::all_of(holder.trunk, [&](const motion::JointPlace& trunk) {
    return distance_to_leaf(leaf.hung, amount, to_floor(trunk.place)) > room;
  });
}

/// On its way from a posture to where it hangs.
motion::ArmPosture hanging_after(const motion::ArmPosture& from, double share) noexcept {
  const auto left = static_cast<float>(1 - share);
  motion::ArmPosture posture = from;
  posture.upper = glm::normalize(glm::mix(Vec3(0.15F, -1, 0), from.upper, left));
  for (float* angle : {&posture.twist, &posture.flexion, &posture.pronation, &posture.wrist_flexion,
                       &posture.wrist_deviation, &posture.lift, &posture.reach})
    *angle *= left;
  return posture;
}

/// At some moment while it is planned, or held.
struct Margin {
  float turned = 0;   ///< The trunk, radians.
  float farther = 0;  ///< The bar, metres.
  double room = 0;    ///< Between an arm's bones and the leaf, metres.
  float off = most_off;
};

bool holds_with(const ClosedLeaf& leaf, const Holder& holder, const Grasp& grasp, double amount,
                const Margin& margin) noexcept {
  constexpr float at_collar = 0.25F;  // metres from what an arm hangs on to the shoulder, and more
  const motion::Grip grip = drawing_grip(leaf.hung, {leaf.slides, amount}, grasp, leaf.floor_height,
                                         holder.body.position);
  const motion::Arm& arm = *holder.arms[grasp.side];
  const Vec3 trunk = holder.trunk[index_of(grasp.side)].place;
  if (glm::distance(trunk, grip.place) > at_collar + arm.upper + arm.fore + arm.hand) return false;
  const Reach reach = reach_for(leaf, holder, grasp.side, grip, margin.turned, margin.farther);
  return reach.off < margin.off &&
         (leaf.slides || is_clear_of(leaf.hung, amount, reach.places, margin.room));
}

/// Does a hand that lets go there come away, without haste, and not through the leaf, which goes
/// on? First it is led; then the arm comes to hang as it does.
bool comes_away(const ClosedLeaf& leaf, const Holder& holder, const Grasp& grasp,
                double amount) noexcept {
  constexpr int parts = 16;
  constexpr float led_off = 0.03F;    // metres that it may be elsewhere
  constexpr float farthest = 0.045F;  // metres that wrist and elbow go in one part
  const motion::Arm& arm = *holder.arms[grasp.side];
  const motion::TrunkBend bend = bend_to(leaf, holder.body, grasp, amount);
  Reach before;
  for (int i = 0; i <= parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    const double now = amount + parting_speed * parting_seconds * share;
    const motion::Grip grip = parting_grip(leaf.hung, {leaf.slides, now}, grasp, leaf.floor_height,
                                           holder.body.position, share);
    const Holder bends =
        bent(holder, straightening(bend, share * parting_seconds / straightening_seconds));
    const Reach reach = reach_for(leaf, bends, grasp.side, grip, 0, 0);
    if (reach.off > led_off || !is_clear_of(leaf.hung, now, reach.places)) return false;
    if (i > 0 && (glm::distance(reach.places.wrist, before.places.wrist) > farthest ||
                  glm::distance(reach.places.elbow, before.places.elbow) > farthest))
      return false;
    before = reach;
  }
  for (int i = 1; i <= parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    const double now = amount + parting_speed * (parting_seconds + hanging_seconds * share);
    const motion::ArmPosture posture = hanging_after(before.posture, share);
    const double straight = (parting_seconds + hanging_seconds * share) / straightening_seconds;
    const Holder bends = bent(holder, straightening(bend, straight));
    const motion::JointPlace& trunk = bends.trunk[index_of(grasp.side)];
    if (!is_clear_of(leaf.hung, now, motion::places_of(holder.skeleton, arm, trunk, posture)))
      return false;
  }
  return true;
}

/// How far a hand takes a leaf; 0 where that is no farther than `least`.
double held_to(const ClosedLeaf& leaf, const Holder& holder, const Grasp& grasp,
               double least) noexcept {
  const double most = most_of(leaf);
  const auto is_held_at = [&](int part) {
    const double amount = most * part / parts_of_way;
    const Holder bends = bent(holder, bend_to(leaf, holder.body, grasp, amount));
    return is_trunk_clear_of(leaf, bends, amount) &&
           std::ranges::all_of(std::array{trunk_sways, -trunk_sways}, [&](float turned) {
             return holds_with(leaf, bends, grasp, amount,
                               {turned, to_spare, thickness_of_arm, planned_off});
           });
  };
  int held = -1;
  while (held < parts_of_way && is_held_at(held + 1)) ++held;
  const auto amount = [&] { return most * held / parts_of_way; };
  while (held > 0 && amount() > least) {
    if (leaf.slides || comes_away(leaf, holder, grasp, amount())) return amount();
    --held;
  }
  return 0;
}

double heading_of(Vec2 direction) noexcept {
  return std::atan2(direction.y, direction.x);
}

/// Outside what the leaf sweeps, some way round from where it is closed; turned to it a little.
void add_stands_of_puller(const ClosedLeaf& leaf, DoorStands& stands) noexcept {
  const HungLeaf& hung = leaf.hung;
  for (const double clear : {0.36, 0.43, 0.5})
    for (const double bearing : {0.28, 0.42, 0.56, 0.7, 0.84})
      for (const double turned : {0.0, 0.3, 0.6, 0.9, 1.2}) {
        const Vec2 place = hung.hinge + (hung.width + clear) * direction_of(hung, bearing);
        const Vec2 facing = -std::cos(turned) * hung.across - std::sin(turned) * hung.along;
        stands.stand[stands.count++] = {
            place, turned == 0 ? heading_of(place - leaf.comes_from) : heading_of(facing)};
      }
}

void add_stands_of_slider(const ClosedLeaf& leaf, DoorStands& stands) noexcept {
  const HungLeaf& hung = leaf.hung;
  for (const double before : {before_slide, before_slide - 0.06, before_slide + 0.06})
    for (const double aside : {0.0, 0.06, -0.06, 0.12, -0.12}) {
      const Vec2 place = hung.hinge + (leaf.passed_at + aside) * hung.along + before * hung.across;
      stands.stand[stands.count++] = {place, heading_of(place - leaf.comes_from)};
    }
}

}  // namespace

std::optional<DoorStop> reach_leaf(const ClosedLeaf& leaf, const Holder& holder) noexcept {
  const double width = leaf.hung.width;
  DoorStop best{.stand = holder.body, .grasp = {}, .held = 0};
  double least = leaf.slides ? worth_sliding : worth_pulling;
  for (const Side side : both_sides) {
    if (!holder.arms[side]) continue;
    for (double along = leaf.slides ? 0.15 : 0.78; along < 0.92;
         along += leaf.slides ? 0.1 : 0.06) {
      const Grasp grasp{side, along * width};
      const double held = held_to(leaf, holder, grasp, least);
      if (held > least) best = {holder.body, grasp, least = held};
    }
  }
  if (best.held == 0) return {};
  return best;
}

motion::TrunkBend bend_to(const ClosedLeaf& leaf, const Placement& body, const Grasp& grasp,
                          double amount) noexcept {
  constexpr double comfortable = 0.5, stretched = 0.3;  // metres to the bar; and beyond
  constexpr float most_lean = 0.4F, most_turn = 0.7F, shoulder_first = 0.5F;
  if (leaf.slides) return {};
  const Vec2 bar = leaf.hung.hinge + grasp.along * direction_of(leaf.hung, amount);
  const Vec2 off = bar - body.position;
  const auto bearing =
      static_cast<float>(std::remainder(heading_of(off) - body.heading, 2 * std::numbers::pi));
  const auto share =
      static_cast<float>(std::clamp((glm::length(off) - comfortable) / stretched, 0.0, 1.0));
  const float eased = share * share * (3 - 2 * share);
  const float first = grasp.side == Side::Right ? shoulder_first : -shoulder_first;
  return {.lean = most_lean * eased,
          .turn = eased * std::clamp(bearing + first, -most_turn, most_turn)};
}

motion::TrunkBend straightening(const motion::TrunkBend& bend, double share) noexcept {
  const auto s = static_cast<float>(std::clamp(share, 0.0, 1.0));
  const float left = 1 - s * s * (3 - 2 * s);
  return {left * bend.lean, left * bend.turn};
}

bool holds_leaf(const ClosedLeaf& leaf, const Holder& holder, const Grasp& grasp,
                double amount) noexcept {
  return holds_with(leaf, holder, grasp, amount, {});
}

DoorStands stands_at(const ClosedLeaf& leaf) noexcept {
  DoorStands stands;
  leaf.slides ? add_stands_of_slider(leaf, stands) : add_stands_of_puller(leaf, stands);
  return stands;
}

Holder moved(const Holder& holder, const Placement& stand) noexcept {
  Holder there = holder;
  there.body = stand;
  const Quat turn =
      glm::angleAxis(static_cast<float>(stand.heading - holder.body.heading), Vec3(0, 1, 0));
  there.waist = to_world(stand.position) + turn * (holder.waist - to_world(holder.body.position));
  for (motion::JointPlace& trunk : there.trunk) {
    trunk.place = to_world(stand.position) + turn * (trunk.place - to_world(holder.body.position));
    trunk.rotation = turn * trunk.rotation;
  }
  return there;
}

/// Farther is better; to turn before and after, and to step aside from the way, is worse.
double worth_of(const ClosedLeaf& leaf, const DoorStop& stop) noexcept {
  const HungLeaf& hung = leaf.hung;
  const Vec2 place = stop.stand.position;
  const Vec2 door = hung.hinge + leaf.passed_at * hung.along;
  const auto turned = [&](Vec2 direction) {
    return std::abs(
        std::remainder(stop.stand.heading - heading_of(direction), 2 * std::numbers::pi));
  };
  const double aside = dot(place - door, hung.along);
  const double before = turned(place - leaf.comes_from);
  return stop.held / most_of(leaf) - (before > 0.05 ? 0.5 + 0.25 * before : 0) -
         0.25 * turned(door - place) - 0.4 * std::abs(aside);
}

double bend_before(const ClosedLeaf& leaf, const DoorStop& stop) noexcept {
  return std::abs(std::remainder(leaf.faces - heading_of(stop.stand.position - leaf.comes_from),
                                 2 * std::numbers::pi));
}

}  // namespace docent::guide
