#include "runtime/guide/doors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/scene/leaf_mesh.h"

namespace docent::guide {
namespace {

constexpr double foreseen = 2.6;  ///< Seconds of its way for which who comes is looked at...
constexpr int looks = 66;            ///< ... so many times.
constexpr double near_a_leaf = 3;        ///< Metres from a leaf's middle to who may come to it.
constexpr double close_by_leaf = 1.6;       ///< Metres: a leaf does not close on who is nearer.
constexpr double stays_open = 3;     ///< Seconds.
constexpr double closing_speed = 0.55, closing_gain = 0.6;  ///< Radians a second, and per second².
constexpr double eased = 0.2;  ///< Seconds over which the turning is spread, ahead.
constexpr double bar_away = scene::bar_surface + 0.01;  ///< Metres from a leaf's middle to the palm on its bar.
constexpr double farthest_reach = 0.56;  ///< Metres level from the shoulder to the bar.
constexpr double shoulder_aside = 0.17;
constexpr double worth_a_hand = 0.01;  ///< Radians.

/// What of a body must be clear of a leaf: the trunk, and the feet that stride ahead of it.
struct Disc {
  double ahead, radius;
};
constexpr std::array pushing_body{Disc{0.02, 0.24}, Disc{0.2, 0.17}};

Vec2 heading_of(const Placement& place) noexcept {
  return {std::cos(place.heading), std::sin(place.heading)};
}

/// As seen by who turns it: by positive angles.
HungLeaf seen(const HungLeaf& leaf, double sign) noexcept {
  return {leaf.hinge, leaf.along, sign * leaf.across, leaf.width};
}

double needed(const HungLeaf& leaf, const Placement& place) noexcept {
  double angle = 0;
  for (const Disc& disc : pushing_body)
    angle = std::max(
        angle, angle_clear_of(leaf, place.position + disc.ahead * heading_of(place), disc.radius));
  return angle;
}

Vec2 middle_of(const Leaf& leaf) noexcept {
  return leaf.hung.hinge + 0.5 * leaf.hung.width * leaf.hung.along;
}

bool is_near(const Leaf& leaf, const Agent& one, double metres) noexcept {
  return one.is_here && one.avatar.floor == leaf.floor && ride_of(one.avatar) == nullptr &&
         glm::distance(one.avatar.body.position, middle_of(leaf)) < metres;
}

/// The next moments of somebody on their way.
struct Foresight {
  std::array<Placement, looks> place;
  double apart = 0;  ///< Seconds.
};

Foresight foresee(const Avatar& avatar, double from) noexcept {
  Foresight ahead;
  ahead.apart = foreseen / (looks - 1);
  for (int i = 0; i < looks; ++i)
    ahead.place[static_cast<std::size_t>(i)] = place_ahead(avatar, from + i * ahead.apart);
  return ahead;
}

/// On which side of the door: 1 to the left of its line from a to b, else -1.
double side_of(const Leaf& leaf, Vec2 place) noexcept {
  return dot(place - leaf.hung.hinge, leaf.hung.across) > 0 ? 1 : -1;
}

/// Does it pass the leaf, from one side to the other?
bool passes(const Leaf& leaf, const Foresight& ahead) noexcept {
  constexpr double body_width = 0.35;
  for (std::size_t i = 1; i < ahead.place.size(); ++i) {
    const Vec2 a = ahead.place[i - 1].position, b = ahead.place[i].position;
    if (side_of(leaf, a) == side_of(leaf, b)) continue;
    const double along = dot(b - leaf.hung.hinge, leaf.hung.along);
    if (along > -body_width && along < leaf.hung.width + body_width) return true;
  }
  return false;
}

/// How far a shoulder has to reach for a grip at worst while the leaf turns; more where the arm
/// has to cross the body.
double farthest(const HungLeaf& leaf, double grip, Side side, const Foresight& ahead,
                std::span<const double> angle, std::size_t first, std::size_t last) noexcept {
  double worst = 0;
  for (std::size_t i = first; i <= last; ++i) {
    const Placement& place = ahead.place[i];
    const Vec2 out = (side == Side::Left ? 1.0 : -1.0) * Vec2{-heading_of(place).y, heading_of(place).x};
    const Vec2 towards = direction_of(leaf, angle[i]);
    const Vec2 back = direction_of(leaf, angle[i] - 1.5707963);
    const Vec2 hand = leaf.hinge + grip * towards + bar_away * back;
    const Vec2 line = hand - place.position - shoulder_aside * out;
    const double crossed = std::max(0.0, -dot(line, out) - 0.12);
    worst = std::max(worst, glm::length(line) + 0.5 * crossed);
  }
  return worst;
}

/// Which hand takes the bar, and where.
void choose_grip(const HungLeaf& leaf, const Foresight& ahead, std::span<const double> angle,
                 std::span<const bool, 2> is_free, Leaf::Push& push) noexcept {
  std::size_t first = 0, last = 0;
  for (std::size_t i = 0; i < angle.size(); ++i) {
    if (angle[i] <= angle.front() + worth_a_hand) first = i;
    if (i > 0 && angle[i] > angle[i - 1] + 1e-4) last = i;
  }
  double best = farthest_reach;
  for (const Side side : both_sides) {
    if (!is_free[index_of(side)]) continue;
    for (double grip = 0.25 * leaf.width; grip < 0.93 * leaf.width; grip += 0.05) {
      const double worst = farthest(leaf, grip, side, ahead, angle, first, std::max(first, last));
      if (worst >= best) continue;
      best = worst;
      push.side = side;
      push.grip = grip;
    }
  }
}

}  // namespace

motion::Grip grip_of(const Leaf& leaf, const Leaf::Push& push, double floor_height) noexcept {
  const HungLeaf it = seen(leaf.hung, push.sign);
  const double angle = push.sign * leaf.angle;
  const Vec2 towards = direction_of(it, angle), back = direction_of(it, angle - 1.5707963);
  const Vec2 inwards = (push.side == Side::Right ? 1.0 : -1.0) * Vec2{back.y, -back.x};
  return {.place = to_world(it.hinge + push.grip * towards + bar_away * back,
                            floor_height + scene::bar_height),
          .fingers = glm::normalize(to_world(-0.8 * back, 0.55)),
          .thumb = to_world(inwards)};
}

Doors::Doors(const Museum& museum) : museum_(museum) {
  for (std::uint32_t floor = 0; floor < museum.floors.size(); ++floor) {
    const FloorPlan& plan = museum.floors[floor].plan;
    for (std::uint32_t door = 0; door < plan.doors.size(); ++door)
      if (!plan.doors[door].closed)
        for (const HungLeaf& hung : leaves_of(plan, plan.doors[door]).all())
          leaves_.push_back(
              {.floor = floor, .door = door, .opens = plan.doors[door].opens, .hung = hung});
  }
}

void Doors::step(double seconds, Crowd& crowd) noexcept {
  for (Leaf& leaf : leaves_) {
    if (!leaf.push) begin_push(seconds, leaf, crowd);
    if (leaf.push)
      turn(seconds, leaf, crowd);
    else
      close(seconds, leaf, crowd);
  }
}

/// Somebody comes, and will need it further open than it is.
void Doors::begin_push(double seconds, Leaf& leaf, const Crowd& crowd) noexcept {
  constexpr double leads = motion::longest_change + eased + 0.1;  // until the hand is there
  for (std::uint32_t who = 0; who < crowd.size(); ++who) {
    const Agent& one = crowd[who];
    if (!is_near(leaf, one, near_a_leaf) || stands(one.avatar)) continue;
    const Foresight ahead = foresee(one.avatar, seconds);
    if (!passes(leaf, ahead)) continue;
    Leaf::Push push{.who = who, .sign = -side_of(leaf, one.avatar.body.position)};
    const HungLeaf it = seen(leaf.hung, push.sign);
    std::array<double, looks> angle;
    const double now = push.sign * leaf.angle;
    double most = now, begins = foreseen;
    for (std::size_t i = 0; i < angle.size(); ++i) {
      most = std::max(most, needed(it, ahead.place[i]));
      if (most > now + worth_a_hand)
        begins = std::min(begins, static_cast<double>(i) * ahead.apart);
      angle[i] = most;
    }
    if (begins > leads || most <= now + worth_a_hand) continue;
    const auto& held = one.avatar.manner.held;
    const std::array<bool, 2> is_free{!held[0], !held[1]};
    choose_grip(it, ahead, angle, is_free, push);
    leaf.push = push;
    leaf.rate = 0;
    return;
  }
}

/// As far as it must be worth_a_hand for who walks there, and some way ahead of that, so that it neither
/// starts nor stops with a jerk.
void Doors::turn(double seconds, Leaf& leaf, Crowd& crowd) noexcept {
  Leaf::Push& push = *leaf.push;
  const Agent& one = crowd[push.who];
  const HungLeaf it = seen(leaf.hung, push.sign);
  const double now = push.sign * leaf.angle;
  const Foresight ahead = foresee(one.avatar, seconds);
  const auto eases = static_cast<std::size_t>(std::ceil(eased / ahead.apart));
  double most = now, sum = 0;
  for (std::size_t i = 0; i < ahead.place.size(); ++i) {
    most = std::max(most, needed(it, ahead.place[i]));
    if (i <= eases) sum += most;
  }
  const double angle = std::max(now, sum / static_cast<double>(eases + 1));
  leaf.angle = push.sign * angle;
  leaf.unused = 0;
  push.since += seconds;
  const bool is_done = most <= angle + 1e-3 || !is_near(leaf, one, near_a_leaf);
  if (push.side) {
    std::optional<Held> held;
    if (!is_done)
      held = Held{grip_of(leaf, push, museum_.floors[leaf.floor].plan.height), push.since};
    crowd.hold(push.who, *push.side, held);
  }
  if (is_done) leaf.push.reset();
}

/// A leaf that nobody uses closes by itself, gently; it waits for who is near, or comes.
void Doors::close(double seconds, Leaf& leaf, const Crowd& crowd) noexcept {
  leaf.unused += seconds;
  for (const Agent& one : crowd.members()) {
    if (leaf.angle == 0) break;
    const bool is_beside = is_near(leaf, one, close_by_leaf);
    const bool comes = !is_beside && is_near(leaf, one, near_a_leaf) && !stands(one.avatar) &&
                       passes(leaf, foresee(one.avatar, seconds));
    if (is_beside || comes) leaf.unused = 0;
  }
  const double open = std::abs(leaf.angle);
  const bool closes = leaf.unused > stays_open && open > 0;
  const double wanted = closes ? std::min(closing_speed, 1.6 * open + 0.02) : 0;
  leaf.rate += std::clamp(wanted - leaf.rate, -4 * closing_gain * seconds, closing_gain * seconds);
  leaf.angle = std::copysign(std::max(0.0, open - leaf.rate * seconds), leaf.angle);
}

void Doors::draw(std::uint32_t floor, scene::DrawList& list) const noexcept {
  for (const Leaf& leaf : leaves_) {
    if (leaf.floor != floor || list.leaves.size() == list.leaves.capacity()) continue;
    list.leaves.push_back({.hinge = leaf.hung.hinge,
                           .along = direction_of(leaf.hung, leaf.angle),
                           .width = static_cast<float>(leaf.hung.width),
                           .floor_height =
                               static_cast<float>(museum_.floors[floor].plan.height)});
  }
}

}  // namespace docent::guide
