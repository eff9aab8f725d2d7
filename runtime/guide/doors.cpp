#include "runtime/guide/doors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/model/none.h"

namespace docent::guide {
namespace {

constexpr std::size_t looks = Foresight::looks;
constexpr double close_by_leaf = 2.6;  ///< Metres: a leaf does not close on who is nearer.
constexpr double stays_open = 4;       ///< Seconds.
constexpr double closing_speed = 0.55, closing_gain = 0.6;  ///< Radians a second, and per second².
constexpr double opening_speed = 1.3;  ///< Radians or metres a second, by itself.
constexpr double opens_early = 1.0;    ///< Seconds.
constexpr double nearly_open = 0.03;   ///< Radians short of open, where a hand lets go.
constexpr double spread_over = 0.2;    ///< Seconds over which the turning is spread, ahead.
constexpr double worth_a_hand = 0.01;  ///< Radians.

/// What of a body must be clear of a leaf: the trunk, and the feet that stride ahead of it.
struct Disc {
  double ahead, radius;
};
constexpr std::array pushing_body{Disc{0.02, 0.32}, Disc{0.2, 0.22}};

Vec2 heading_of(const Placement& place) noexcept {
  return {std::cos(place.heading), std::sin(place.heading)};
}

double needed(const HungLeaf& leaf, const Placement& place) noexcept {
  double angle = 0;
  for (const Disc& disc : pushing_body)
    angle = std::max(
        angle, angle_clear_of(leaf, place.position + disc.ahead * heading_of(place), disc.radius));
  return angle;
}

/// A turning leaf as who turns it sees it, moment by moment.
struct Turning {
  HungLeaf leaf;
  std::array<double, looks> angle{};
  std::size_t first = 0, last = 0;  ///< When it turns.
};

/// Is a leaf that is open towards who comes out of their way as it is?
bool is_out_of_the_way(const Leaf& leaf, double sign, const Foresight& ahead) noexcept {
  if (sign * leaf.angle > -worth_a_hand) return false;
  return std::ranges::all_of(ahead.place, [&](const Placement& place) {
    return std::ranges::all_of(pushing_body, [&](const Disc& disc) {
      const Vec2 middle = place.position + disc.ahead * heading_of(place);
      return distance_to_leaf(leaf.hung, leaf.angle, middle) > disc.radius - 0.07;
    });
  });
}

/// A hand has let go of it.
void swing_open(double seconds, bool is_free, Leaf& leaf) noexcept {
  constexpr double speed = 0.8, nearly = 0.02;
  const double most = leaf.waits > 0 ? parting_speed : speed;
  leaf.waits -= seconds;
  open_on(seconds, is_free ? most : 0, leaf);
  if (opening_of(leaf) > full_opening(leaf) - nearly) leaf.swings_open = false;
}

/// It does not open by itself meanwhile.
bool is_left_to_a_hand(const Leaf& leaf) noexcept {
  return leaf.drawing || leaf.search;
}

/// Of two that slide, the other goes along.
void follow(const Leaf& leaf, Leaf& other) noexcept {
  other.slid = std::max(other.slid, std::min(leaf.slid, full_opening(other)));
  other.rate = leaf.rate;
  other.unused = leaf.unused;
}

/// How far who comes will have turned a leaf by then, if they turn it from `now` on: as far as they
/// need it soon. A leaf that is half open is opened further while the hand still lies before the
/// body, and it neither starts nor stops with a jerk.
/// `most`: what they have needed so far; grows to what they need at the first of these moments.
std::array<double, looks> foresee_angles(const HungLeaf& leaf, double now, const Foresight& ahead,
                                         double& most) noexcept {
  constexpr double half_open = 0.7;  // radians
  std::array<double, looks> need, angle;
  most = std::max(most, needed(leaf, ahead.place[0]));
  need[0] = most;
  for (std::size_t i = 1; i < looks; ++i)
    need[i] = std::max(need[i - 1], needed(leaf, ahead.place[i]));
  const auto at = [&](double index) {
    const double i = std::min(index, static_cast<double>(looks - 1));
    const auto before = static_cast<std::size_t>(i);
    return std::lerp(need[before], need[std::min<std::size_t>(before + 1, looks - 1)],
                     i - static_cast<double>(before));
  };
  for (std::size_t i = 0; i < looks; ++i) {
    const double share = std::clamp((need[i] - worth_a_hand) / half_open, 0.0, 1.0);
    const double early = opens_early * share * share * (3 - 2 * share);
    double sum = 0;
    constexpr int parts = 6;
    for (int k = 0; k < parts; ++k)
      sum +=
          at(static_cast<double>(i) + (early + spread_over * k / (parts - 1)) / Foresight::apart);
    angle[i] = std::max(i > 0 ? angle[i - 1] : now, sum / parts);
  }
  return angle;
}

/// Where no hand reaches it, a leaf opens by itself, in time.
double opened_by_itself(double now, std::span<const double, looks> wanted,
                        double seconds) noexcept {
  constexpr double speed = 1.5, gain = 3;  // radians a second, and per second and radian
  const double left = std::max(0.0, wanted.back() - now);
  return std::max(wanted.front(), now + std::min(speed, gain * left) * seconds);
}

/// How who comes will turn a leaf; nothing where it is open enough.
std::optional<Turning> foresee_turning(const Leaf& leaf, double sign,
                                       const Foresight& ahead) noexcept {
  if (is_out_of_the_way(leaf, sign, ahead)) return {};
  const double now = sign * leaf.angle;
  Turning turning{.leaf = seen(leaf.hung, sign)};
  double most = 0;
  turning.angle = foresee_angles(turning.leaf, now, ahead, most);
  if (turning.angle.back() <= now + worth_a_hand) return {};
  while (turning.angle[turning.first + 1] <= now + 1e-4) ++turning.first;
  turning.last = looks - 1;
  // Who begins right before a leaf turns it all the way at once.
  while (turning.last > turning.first + 1 &&
         turning.angle[turning.last - 1] >= turning.angle.back() - 1e-3)
    --turning.last;
  return turning;
}

/// The trunk, where a body will be, held as it is now.
motion::JointPlace trunk_at(const Placement& now, const Placement& then,
                            const motion::JointPlace& trunk) noexcept {
  const Quat turn = glm::angleAxis(static_cast<float>(then.heading - now.heading), Vec3(0, 1, 0));
  return {to_world(then.position) + turn * (trunk.place - to_world(now.position)),
          turn * trunk.rotation};
}

/// A trunk as an arm hangs on it.
motion::JointPlace trunk_of(const Avatar& avatar, const motion::Arm& arm) noexcept {
  const Mat4& now = avatar.world[index_of(arm.trunk)];
  return {Vec3(now[3]), glm::normalize(glm::quat_cast(now))};
}

/// Will the hand be on the bar, in the next frame, where the leaf is turned so?
bool reaches_bar(const Skeleton& skeleton, const Avatar& avatar, const Placement& then,
                 const HungLeaf& leaf, double angle, const Grasp& grasp, double height) noexcept {
  constexpr float most_missed = 0.012F;  // metres
  const motion::Arm& arm = *avatar.limbs.arms[grasp.side];
  const motion::JointPlace trunk = trunk_at(avatar.body, then, trunk_of(avatar, arm));
  motion::Grip grip = pushing_grip(leaf, angle, grasp, height);
  const auto ground = static_cast<float>(height);
  grip.place.y = ground + (grip.place.y - ground) / build_of(avatar);
  const motion::ArmPosture posture = motion::holding(skeleton, arm, trunk, grip);
  return glm::distance(motion::palm_of(skeleton, arm, trunk, posture), grip.place) < most_missed;
}

/// How far a palm is from its grip at worst while the leaf turns, metres, and a little more the
/// farther the arm has to reach.
double discomfort(const Skeleton& skeleton, const Avatar& avatar, const Foresight& ahead,
                  const Turning& turning, const Grasp& grasp, double height) noexcept {
  constexpr std::size_t samples = 16;
  constexpr float sway = 0.12F;  // of a trunk that walks, radians
  const motion::Arm& arm = *avatar.limbs.arms[grasp.side];
  const motion::JointPlace trunk = trunk_of(avatar, arm);
  double worst = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const std::size_t at = turning.first + (turning.last - turning.first) * i / (samples - 1);
    const motion::Grip grip = pushing_grip(turning.leaf, turning.angle[at], grasp, height);
    motion::JointPlace then = trunk_at(avatar.body, ahead.place[at], trunk);
    then.rotation = glm::angleAxis(i % 2 == 0 ? sway : -sway, Vec3(0, 1, 0)) * then.rotation;
    const motion::ArmPosture posture = motion::holding(skeleton, arm, then, grip);
    const double off = glm::distance(motion::palm_of(skeleton, arm, then, posture), grip.place);
    worst =
        std::max(worst, off + 0.01 * static_cast<double>(glm::distance(then.place, grip.place)));
  }
  return worst;
}

/// Which hand takes the bar, and where; none where none can hold it all the while.
std::optional<Grasp> choose_grasp(const Skeleton& skeleton, const Avatar& avatar,
                                  const Foresight& ahead, const Turning& turning,
                                  double height) noexcept {
  constexpr double good_enough = 0.04;
  std::optional<Grasp> chosen;
  double best = good_enough;
  for (const Side side : both_sides) {
    if (!avatar.limbs.arms[side] || avatar.manner.held[index_of(side)]) continue;
    const double width = turning.leaf.width;
    for (double along = 0.2 * width; along < 0.92 * width; along += 0.08 * width) {
      const Grasp grasp{side, along};
      const double worst = discomfort(skeleton, avatar, ahead, turning, grasp, height);
      if (worst >= best) continue;
      best = worst;
      chosen = grasp;
    }
  }
  return chosen;
}

}  // namespace

motion::Grip grip_of(const Leaf& leaf, const Leaf::Push& push, double floor_height) noexcept {
  return pushing_grip(seen(leaf.hung, push.sign), push.sign * leaf.angle, *push.grasp,
                      floor_height);
}

Doors::Doors(const Museum& museum) : museum_(museum), standing_(standing(museum)) {
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
    const Leaf* other = other_leaf(leaf);
    if (!leaf.push && !leaf.drawing && !leaf.search) begin_search(leaf, crowd);
    if (leaf.search) search(leaf, crowd);
    if (leaf.drawing) come_to_draw(seconds, leaf, crowd);
    if (!leaf.push && !(leaf.drawing && leaf.drawing->has_come)) begin_push(seconds, leaf, crowd);
    const bool is_left = is_left_to_a_hand(leaf) || (other != nullptr && is_left_to_a_hand(*other));
    if (leaf.push)
      turn(seconds, leaf, crowd);
    else if (leaf.drawing && leaf.drawing->has_come)
      draw_open(seconds, leaf, crowd);
    else if (!is_left && is_awaited(leaf, crowd))
      open_on(seconds, may_open_on(leaf, crowd) ? opening_speed : 0, leaf);
    else if (!is_left && leaf.swings_open)
      swing_open(seconds, may_open_on(leaf, crowd), leaf);
    else
      close(seconds, leaf, crowd);
  }
  for (Leaf& leaf : leaves_)
    if (leaf.drawing && leaf.opens == DoorOpens::Sliding)
      if (Leaf* other = other_leaf(leaf)) follow(leaf, *other);
}

/// Somebody comes, and will need it further open than it is.
void Doors::begin_push(double seconds, Leaf& leaf, const Crowd& crowd) noexcept {
  constexpr double leads = motion::longest_change + spread_over + 0.1;  // until the hand is there
  for (std::uint32_t who = 0; who < crowd.size(); ++who) {
    const Agent& one = crowd[who];
    if (!is_near(leaf, one, near_a_leaf) || stands(one.avatar)) continue;
    const Foresight ahead = foresee(one.avatar, seconds);
    if (!passes(leaf, ahead) || is_drawn(leaf, one.avatar.body.position)) continue;
    Leaf::Push push{.who = who, .sign = -side_of(leaf, one.avatar.body.position)};
    const std::optional<Turning> turning = foresee_turning(leaf, push.sign, ahead);
    if (push.sign * leaf.angle < -worth_a_hand) continue;  // it closes first
    if (!turning || static_cast<double>(turning->first) * Foresight::apart > leads) continue;
    push.grasp = choose_grasp(museum_.motion.skeleton, one.avatar, ahead, *turning,
                              museum_.floors[leaf.floor].plan.height);
    const double left = static_cast<double>(turning->first) * Foresight::apart;
    if (!push.grasp && left > motion::longest_change + 0.02) continue;  // nearer by, perhaps
    leaf.push = push;
    leaf.search.reset();
    leaf.rate = 0;
    leaf.swings_open = false;
    return;
  }
}

/// As far as is wanted, where the hand comes along; else it waits for that, unless the body is
/// there, and then catches up.
double Doors::turned_by_hand(double seconds, double wanted, const Foresight& ahead, Leaf& leaf,
                             const Avatar& avatar) const noexcept {
  constexpr double brake = 12, catches_up = 6;  // radians a second, and second
  Leaf::Push& push = *leaf.push;
  if (seconds <= 0) return push.sign * leaf.angle;
  const HungLeaf it = seen(leaf.hung, push.sign);
  const double now = push.sign * leaf.angle;
  const bool is_reached = push.since < motion::longest_change ||
                          reaches_bar(museum_.motion.skeleton, avatar, ahead.place[0], it, wanted,
                                      *push.grasp, museum_.floors[leaf.floor].plan.height);
  push.waits = push.waits || !is_reached;
  push.apart = is_reached ? 0 : push.apart + seconds;
  double rate = (wanted - now) / seconds;
  if (push.waits) {
    const double most = push.rate + (is_reached ? catches_up : -brake) * seconds;
    push.waits = !is_reached || rate > most;
    rate = std::clamp(rate, 0.0, std::max(0.0, most));
  }
  push.rate = rate;
  return std::max(now + rate * seconds, std::min(wanted, needed(it, ahead.place[0])));
}

/// As far as it must be worth_a_hand for who walks there, and some way ahead of that, so that it
/// neither starts nor stops with a jerk.
void Doors::turn(double seconds, Leaf& leaf, Crowd& crowd) noexcept {
  Leaf::Push& push = *leaf.push;
  const Agent& one = crowd[push.who];
  const HungLeaf it = seen(leaf.hung, push.sign);
  const double now = push.sign * leaf.angle;
  const Foresight ahead = foresee(one.avatar, seconds);
  const std::array<double, looks> angle = foresee_angles(it, now, ahead, push.needed);
  const bool is_done = angle.back() <= now + nearly_open || !is_near(leaf, one, near_a_leaf);
  const double floor = museum_.floors[leaf.floor].plan.height;
  if (!is_done && push.grasp)
    leaf.angle = push.sign * turned_by_hand(seconds, angle.front(), ahead, leaf, one.avatar);
  else if (!is_done)
    leaf.angle = push.sign * opened_by_itself(now, angle, seconds);
  leaf.unused = 0;
  push.since += seconds;
  if (push.grasp) {
    std::optional<Held> held;
    if (!is_done) {
      held = Held{grip_of(leaf, push, floor), push.since};
      // Somebody who is drawn taller than life reaches less high for the same bar.
      const auto ground = static_cast<float>(floor);
      held->grip.place.y = ground + (held->grip.place.y - ground) / build_of(one.avatar);
    }
    crowd.hold(push.who, push.grasp->side, held);
  }
  // Who has left it behind lets go of it.
  constexpr double lets_go_after = 0.25;  // seconds
  const bool is_past = side_of(leaf, one.avatar.body.position) == push.sign;
  if (push.grasp && push.apart > lets_go_after && is_past) {
    crowd.hold(push.who, push.grasp->side, {});
    push.grasp.reset();
  }
  if (is_done) leaf.push.reset();
}

/// Does somebody come before whom it opens by itself?
bool Doors::is_awaited(const Leaf& leaf, const Crowd& crowd) const noexcept {
  return std::ranges::any_of(crowd.members(), [&](const Agent& one) {
    return is_near(leaf, one, drawn_from) && !stands(one.avatar) &&
           is_drawn(leaf, one.avatar.body.position) &&
           passing_within(drawn_ahead, leaf, one.avatar);
  });
}

/// A leaf that nobody uses closes by itself, gently; it waits for who is near, or comes.
void Doors::close(double seconds, Leaf& leaf, const Crowd& crowd) noexcept {
  leaf.unused += seconds;
  for (const Agent& one : crowd.members()) {
    if (opening_of(leaf) == 0) break;
    if (!is_near(leaf, one, near_a_leaf)) continue;
    const Foresight ahead = foresee(one.avatar, seconds);
    const bool comes = !stands(one.avatar) && passes(leaf, ahead);
    const double sign = -side_of(leaf, one.avatar.body.position);
    if (comes && sign * leaf.angle < 0 && !is_out_of_the_way(leaf, sign, ahead)) {
      leaf.unused = std::max(leaf.unused, stays_open + seconds);  // half open towards them
      break;
    }
    if (comes || is_near(leaf, one, close_by_leaf)) leaf.unused = 0;
  }
  const double open = opening_of(leaf);
  const bool closes = leaf.unused > stays_open && open > 0;
  const double wanted = closes ? std::min(closing_speed, 1.6 * open + 0.02) : 0;
  leaf.rate += std::clamp(wanted - leaf.rate, -4 * closing_gain * seconds, closing_gain * seconds);
  set_opening(std::max(0.0, open - leaf.rate * seconds), leaf);
}

void Doors::draw(std::uint32_t floor, scene::DrawList& list) const noexcept {
  for (const Leaf& leaf : leaves_) {
    if (leaf.floor != floor || list.leaves.size() == list.leaves.capacity()) continue;
    list.leaves.push_back({.hinge = leaf.hung.hinge - leaf.slid * leaf.hung.along,
                           .along = direction_of(leaf.hung, leaf.angle),
                           .width = static_cast<float>(leaf.hung.width),
                           .floor_height = static_cast<float>(museum_.floors[floor].plan.height)});
  }
}

}  // namespace docent::guide
