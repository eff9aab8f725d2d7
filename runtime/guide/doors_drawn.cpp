// Leaves that are pulled open, or slid, by who stops before them.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/guide/doors.h"

namespace docent::guide {
namespace {

constexpr double in_time = 1.6;        ///< Seconds before it passes, when who comes may still stop.
constexpr double too_late = 1.3;       ///< Seconds before, when a leaf opens by itself after all.
constexpr double reaches_ahead = 0.6;  ///< Seconds before it stands.
constexpr double waits_for_hand = 10;  ///< Seconds.
constexpr double longest_way = 6;      ///< Seconds to where it stops, or it does not.
constexpr double pulling_speed = 0.85, sliding_speed = 0.7;  ///< Radians, metres a second.
constexpr double speeding_up = 0.5;                          ///< Seconds.
constexpr double likes_straight = 4;                         ///< Of a stop's worth, per radian.
constexpr double stands_off = 0.08,
                 turned_off = 0.2;          ///< Metres, radians that one may stand otherwise.
constexpr double apart_from_others = 0.15;  ///< Metres between circles, of others and who stops.
constexpr double out_of_sweep = 0.34;  ///< Metres from a leaf to the middle of who stands there.
constexpr double next_sweep = 0.35;    ///< Radians that a leaf looks ahead for who is in its way.
constexpr double barely = 0.01;        ///< Radians, or metres, that it may be open.

/// How far it has been moved after so many seconds: it speeds up gently, then moves evenly.
double moved_after(double seconds, double speed) noexcept {
  const double u = std::min(seconds / speeding_up, 1.0);
  const double eased = speeding_up * (u * u * u - 0.5 * u * u * u * u);
  return speed * (eased + std::max(0.0, seconds - speeding_up));
}

/// The hand goes with it; it stops for who is in its way.
void move(double seconds, bool is_free, Leaf& leaf) noexcept {
  constexpr double brake = 4;  // a share of the pace a second
  Leaf::Drawing& it = *leaf.drawing;
  if (it.since <= motion::longest_change) return;
  it.pace = std::clamp(is_free ? 1.0 : 0.0, it.pace - brake * seconds, it.pace + brake * seconds);
  it.moved += it.pace * seconds;
  const double before = opening_of(leaf);
  const double speed = leaf.opens == DoorOpens::Sliding ? sliding_speed : pulling_speed;
  set_opening(std::min(moved_after(it.moved, speed), full_opening(leaf)), leaf);
  leaf.rate = -(opening_of(leaf) - before) / seconds;  // a rate is of closing
}

/// Where somebody will be, also after the stretch of their way that has been walked out so far.
Vec2 place_on_way(const Avatar& avatar, double seconds) noexcept {
  const plan::Plan& plan = *avatar.plan;
  if (avatar.next || plan.is_whole || plan.points.empty() ||
      avatar.seconds + seconds < plan.seconds())
    return place_ahead(avatar, seconds).position;
  return plan::point_along(plan, avatar.along + walking_pace * seconds);
}

/// It bends as the hand comes, and straightens as that comes away.
motion::TrunkBend bend_of(const ClosedLeaf& leaf, const Placement& body, double opening,
                          const Leaf::Drawing& it) noexcept {
  const motion::TrunkBend bend = bend_to(leaf, body, it.stop.grasp, opening);
  return straightening(straightening(bend, 1 - it.since / motion::longest_change),
                       it.parts / straightening_seconds);
}

bool is_at(const Placement& body, const Placement& place) noexcept {
  return glm::distance(body.position, place.position) < stands_off &&
         std::abs(std::remainder(body.heading - place.heading, 2 * std::numbers::pi)) < turned_off;
}

}  // namespace

Leaf* Doors::other_leaf(const Leaf& leaf) noexcept {
  const auto other = std::ranges::find_if(leaves_, [&](const Leaf& it) {
    return &it != &leaf && it.floor == leaf.floor && it.door == leaf.door;
  });
  return other == leaves_.end() ? nullptr : &*other;
}

ClosedLeaf Doors::closed(const Leaf& leaf, double sign, double passed_at) const noexcept {
  return {.hung = seen(leaf.hung, sign),
          .slides = leaf.opens == DoorOpens::Sliding,
          .passed_at = passed_at,
          .floor_height = museum_.floors[leaf.floor].plan.height};
}

Holder Doors::holder_of(const Avatar& avatar) const noexcept {
  Holder holder{.skeleton = museum_.motion.skeleton,
                .arms = avatar.limbs.arms,
                .body = avatar.body,
                .trunk = {},
                .waist = {},
                .height = static_cast<double>(build_of(avatar))};
  if (const JointIndex spine = museum_.motion.skeleton[BodyPart::Spine]; spine != JointIndex::None)
    holder.waist = Vec3(avatar.world[index_of(spine)][3]);
  for (const Side side : both_sides)
    if (const auto& arm = avatar.limbs.arms[side]) {
      const Mat4& trunk = avatar.world[index_of(arm->trunk)];
      holder.trunk[index_of(side)] = {Vec3(trunk[3]), glm::normalize(glm::quat_cast(trunk))};
    }
  return holder;
}

/// Somebody who stands, somewhere.
Avatar Doors::standing(const Museum& museum) {
  return make_avatar(museum, museum.kiosk_floor, plan::make_standing(museum, museum.kiosk));
}

/// Room among walls, other leaves and others.
bool Doors::is_free_for(std::uint32_t who, Vec2 place, const Leaf& leaf,
                        const Crowd& crowd) const noexcept {
  const double radius = museum_.body_radius;
  if (!crowd.has_room(leaf.floor, place, radius + Museum::walking_room)) return false;
  for (const Leaf& other : leaves_)
    if (&other != &leaf && other.floor == leaf.floor &&
        distance_to_leaf(other.hung, other.angle, place) < out_of_sweep)
      return false;
  for (std::uint32_t other = 0; other < crowd.size(); ++other) {
    const Agent& one = crowd[other];
    if (other != who && one.is_here && one.avatar.floor == leaf.floor &&
        glm::distance(one.avatar.body.position, place) < 2 * radius + apart_from_others)
      return false;
  }
  return true;
}

/// Does it sweep through nobody, in so many radians? Who comes to go through is not in its way.
bool Doors::is_sweep_free(const Leaf& leaf, double ahead, const Crowd& crowd) const noexcept {
  constexpr double step = 0.15;  // radians
  if (leaf.opens == DoorOpens::Sliding) return true;
  const double to = std::min(opening_of(leaf) + ahead, full_opening(leaf));
  return std::ranges::none_of(crowd.members(), [&](const Agent& one) {
    if (!is_near(leaf, one, near_a_leaf)) return false;
    const auto is_met_at = [&](double angle) {
      return distance_to_leaf(leaf.hung, -angle, one.avatar.body.position) < museum_.body_radius;
    };
    bool is_met = is_met_at(to);
    for (double angle = opening_of(leaf); angle < to; angle += step)
      is_met = is_met || is_met_at(angle);
    return is_met && (stands(one.avatar) || !passing_within(drawn_ahead, leaf, one.avatar));
  });
}

/// A leaf that no hand is on waits for who is in its way, until somebody has to go through.
bool Doors::may_open_on(const Leaf& leaf, const Crowd& crowd) const noexcept {
  return is_sweep_free(leaf, next_sweep, crowd) ||
         std::ranges::any_of(crowd.members(), [&](const Agent& one) {
           return is_near(leaf, one, near_a_leaf) && !stands(one.avatar) &&
                  passing_within(in_time, leaf, one.avatar);
         });
}

/// Somebody comes to whom it is closed, perhaps in time to stop before it.
void Doors::begin_search(Leaf& leaf, const Crowd& crowd) noexcept {
  if (leaf.opens != DoorOpens::Pull && leaf.opens != DoorOpens::Sliding) return;
  if (leaf.lets && !is_near(leaf, crowd[*leaf.lets], drawn_from + 0.5)) leaf.lets.reset();
  if (opening_of(leaf) > barely) return;
  const Leaf* other = other_leaf(leaf);
  if (other != nullptr && (other->drawing || other->search || other->push)) return;
  if (other != nullptr && leaf.opens == DoorOpens::Pull && !is_wide_enough(leaf.hung)) return;
  for (std::uint32_t who = 0; who < crowd.size(); ++who) {
    const Agent& one = crowd[who];
    if (!is_near(leaf, one, drawn_from) || leaf.lets == who || stands(one.avatar) ||
        !crowd.can_stop_over(who) || !is_drawn(leaf, one.avatar.body.position))
      continue;
    const auto passing = passing_within(drawn_ahead, leaf, one.avatar);
    if (!passing || passing->along < 0 || passing->along > leaf.hung.width + barely) continue;
    leaf.lets = who;
    if (passing->seconds < in_time) continue;
    const auto comes_from = last_bend(leaf, one, *passing, crowd);
    if (!comes_from) continue;
    leaf.search = {.who = who,
                   .sign = side_of(leaf, one.avatar.body.position),
                   .passed_at = passing->along,
                   .comes_from = *comes_from,
                   .faces = one.avatar.body.heading};
    return;
  }
}

/// From where on somebody who comes could go straight to a place before the leaf.
std::optional<Vec2> Doors::last_bend(const Leaf& leaf, const Agent& one, const LeafPassing& passing,
                                     const Crowd& crowd) const noexcept {
  constexpr double search_lasts = 0.4, apart = 0.3;  // seconds, about
  const Vec2 before = leaf.hung.hinge + passing.along * leaf.hung.along +
                      before_slide * side_of(leaf, one.avatar.body.position) * leaf.hung.across;
  for (double at = one.lead + search_lasts; at < passing.seconds - apart; at += apart) {
    const Vec2 place = place_on_way(one.avatar, at);
    if (crowd.is_clear(leaf.floor, place, before, museum_.body_radius)) return place;
  }
  return {};
}

/// Where they best stop. It is looked for some places at a time: a frame has little to spare.
void Doors::search(Leaf& leaf, Crowd& crowd) const noexcept {
  const std::size_t at_once = leaf.opens == DoorOpens::Sliding ? 1 : 2;
  Leaf::Search& search = *leaf.search;
  const Agent& one = crowd[search.who];
  if (!crowd.can_stop_over(search.who)) {
    // Who waits for the next stretch of their way can again, soon.
    if (!is_near(leaf, one, drawn_from) || !one.goal || one.has_arrived ||
        passing_within(in_time, leaf, one.avatar))
      leaf.search.reset();
    return;
  }
  ClosedLeaf it = closed(leaf, search.sign, search.passed_at);
  it.comes_from = search.comes_from;
  it.faces = search.faces;
  Holder holder = holder_of(standing_);
  holder.height = static_cast<double>(build_of(one.avatar));
  const auto up = static_cast<float>(it.floor_height - standing_.height);
  holder.waist.y += up;
  for (motion::JointPlace& trunk : holder.trunk) trunk.place.y += up;
  const DoorStands stands = stands_at(it);
  const std::size_t end = std::min(search.looked_at + at_once, stands.count);
  for (; search.looked_at < end; ++search.looked_at) {
    const Placement& stand = stands.stand[search.looked_at];
    if (!is_free_for(search.who, stand.position, leaf, crowd) ||
        !crowd.is_clear(leaf.floor, it.comes_from, stand.position, museum_.body_radius))
      continue;
    const auto stop = reach_leaf(it, moved(holder, stand));
    if (!stop) continue;
    const auto straight = [&](const DoorStop& a) {
      return worth_of(it, a) - likes_straight * bend_before(it, a);
    };
    if (!search.best || worth_of(it, *stop) > worth_of(it, *search.best)) search.best = stop;
    if (!search.straight || straight(*stop) > straight(*search.straight)) search.straight = stop;
  }
  if (end == stands.count) begin_drawing(leaf, crowd);
}

/// It has been found, if there is a place, and is still free.
void Doors::begin_drawing(Leaf& leaf, Crowd& crowd) const noexcept {
  const Leaf::Search found = *std::exchange(leaf.search, {});
  const auto passing = passing_within(drawn_ahead, leaf, crowd[found.who].avatar);
  if (!found.best || !passing || passing->seconds < in_time ||
      !is_free_for(found.who, found.best->stand.position, leaf, crowd))
    return;
  leaf.drawing = {
      .who = found.who, .sign = found.sign, .stop = *found.best, .other = found.straight};
  crowd.stop_over(found.who, found.best->stand);
}

/// Until who comes stands there. Told something else, or where others come first, they leave it.
void Doors::come_to_draw(double seconds, Leaf& leaf, Crowd& crowd) noexcept {
  Leaf::Drawing& it = *leaf.drawing;
  const Agent& one = crowd[it.who];
  const bool others_come = std::ranges::any_of(crowd.members(), [&](const Agent& other) {
    if (&other == &one || !is_near(leaf, other, near_a_leaf) || stands(other.avatar)) return false;
    return passing_within(in_time, leaf, other.avatar).has_value();
  });
  const bool is_left = !one.stops_at || others_come || leaf.push;
  if (is_left && !it.has_come) return let_go(leaf, crowd);
  it.since += seconds;
  if (it.has_come) {
    if (is_left && it.parts == 0) it.parts = seconds;
    return;
  }
  if (it.since > waits_for_hand) return let_go(leaf, crowd);
  if (!one.is_diverted) {
    if (passing_within(too_late, leaf, one.avatar)) let_go(leaf, crowd);
    return;
  }
  const double left = crowd.seconds_to_stop(it.who);
  if (std::isfinite(left) && left > longest_way) {
    if (!it.other || it.other->stand.position == it.stop.stand.position) return let_go(leaf, crowd);
    it.stop = *std::exchange(it.other, {});
    return crowd.stop_over(it.who, it.stop.stand);
  }
  if (left > reaches_ahead) return;
  if (!is_at(place_ahead(one.avatar, reaches_ahead), it.stop.stand)) return let_go(leaf, crowd);
  it.has_come = true;
  it.since = 0;
}

/// The hand comes to the bar, goes with it, and comes away beside the leaf.
void Doors::draw_open(double seconds, Leaf& leaf, Crowd& crowd) noexcept {
  constexpr double patience = 6;       // seconds
  constexpr double slows_down = 0.15;  // metres, or radians, before it is all open
  constexpr double waits_before = 0.15;
  Leaf::Drawing& it = *leaf.drawing;
  const ClosedLeaf now = closed(leaf, it.sign, 0);
  if (it.parts == 0) {
    const double far = std::min(it.stop.held, full_opening(leaf) - slows_down);
    // It is let go only where it can go on.
    const bool goes_far = opening_of(leaf) > far - waits_before;
    const bool is_free = is_sweep_free(leaf, goes_far ? full_opening(leaf) : next_sweep, crowd);
    move(seconds, crowd.stands_over(it.who) && is_free, leaf);
    const bool is_held = it.pace == 0 || holds_leaf(now, holder_of(crowd[it.who].avatar),
                                                    it.stop.grasp, opening_of(leaf));
    const bool is_stuck = it.since > it.moved + motion::longest_change + patience;
    if (!is_held || is_stuck || opening_of(leaf) >= far) it.parts = seconds;
  } else {
    it.parts += seconds;
    const double speed = leaf.opens == DoorOpens::Sliding ? sliding_speed : parting_speed;
    if (opening_of(leaf) > barely) open_on(seconds, may_open_on(leaf, crowd) ? speed : 0, leaf);
  }
  leaf.unused = 0;
  // Who walks off has no hand to lead any more.
  if (it.parts > parting_seconds || (it.parts > 0 && !stands(crowd[it.who].avatar)))
    return let_go(leaf, crowd);
  Held held{
      parting_grip(now.hung, {now.slides, opening_of(leaf)}, it.stop.grasp, now.floor_height,
                   crowd[it.who].avatar.body.position, std::min(it.parts / parting_seconds, 1.0)),
      it.since, bend_of(now, crowd[it.who].avatar.body, opening_of(leaf), it)};
  const auto ground = static_cast<float>(now.floor_height);
  held.grip.place.y = ground + (held.grip.place.y - ground) / build_of(crowd[it.who].avatar);
  crowd.hold(it.who, it.stop.grasp.side, held);
}

/// The leaf goes on as it moves, or closes where it has hardly moved; whoever stopped goes on.
void Doors::let_go(Leaf& leaf, Crowd& crowd) const noexcept {
  constexpr double far_enough = 0.3;
  const Leaf::Drawing& it = *leaf.drawing;
  if (it.has_come) crowd.hold(it.who, it.stop.grasp.side, {});
  crowd.go_on_from_stop(it.who);
  leaf.swings_open = opening_of(leaf) > far_enough;
  leaf.waits = leaf.opens == DoorOpens::Sliding ? 0 : hanging_seconds;
  leaf.drawing.reset();
}

}  // namespace docent::guide
