#include "runtime/guide/leaf.h"

#include <algorithm>
#include <cmath>

namespace docent::guide {

Foresight foresee(const Avatar& avatar, double from) noexcept {
  Foresight ahead;
  for (std::size_t i = 0; i < Foresight::looks; ++i)
    ahead.place[i] = place_ahead(avatar, from + static_cast<double>(i) * Foresight::apart);
  return ahead;
}

namespace {

/// Between two moments.
std::optional<double> crossing_of(const Leaf& leaf, Vec2 from, Vec2 to) noexcept {
  constexpr double body_width = 0.35;
  if (side_of(leaf, from) == side_of(leaf, to)) return {};
  const double along = dot(to - leaf.hung.hinge, leaf.hung.along);
  if (along <= -body_width || along >= leaf.hung.width + body_width) return {};
  return along;
}

/// Of a way of which only a stretch has been walked out so far.
std::optional<LeafPassing> passing_on_way(double seconds, const Leaf& leaf,
                                          const Avatar& avatar) noexcept {
  constexpr double step = 0.1;  // metres
  if (avatar.plan->points.empty()) return {};
  Vec2 before = avatar.body.position;
  for (double ahead = step; ahead < walking_pace * seconds; ahead += step) {
    const Vec2 place = plan::point_along(*avatar.plan, avatar.along + ahead);
    if (const auto along = crossing_of(leaf, before, place))
      return LeafPassing{*along, ahead / walking_pace};
    before = place;
  }
  return {};
}

}  // namespace

std::optional<LeafPassing> passing_within(double seconds, const Leaf& leaf,
                                          const Avatar& avatar) noexcept {
  Vec2 before = avatar.body.position;
  for (double at = Foresight::apart; at < seconds; at += Foresight::apart) {
    const Vec2 place = place_ahead(avatar, at).position;
    if (const auto along = crossing_of(leaf, before, place)) return LeafPassing{*along, at};
    before = place;
  }
  if (avatar.next || avatar.plan->is_whole) return {};
  return passing_on_way(seconds, leaf, avatar);
}

bool passes(const Leaf& leaf, const Foresight& ahead) noexcept {
  for (std::size_t i = 1; i < ahead.place.size(); ++i)
    if (crossing_of(leaf, ahead.place[i - 1].position, ahead.place[i].position)) return true;
  return false;
}

bool is_near(const Leaf& leaf, const Agent& one, double metres) noexcept {
  const Vec2 middle = leaf.hung.hinge + 0.5 * leaf.hung.width * leaf.hung.along;
  return one.is_here && one.avatar.floor == leaf.floor && ride_of(one.avatar) == nullptr &&
         glm::distance(one.avatar.body.position, middle) < metres;
}

double side_of(const Leaf& leaf, Vec2 place) noexcept {
  return dot(place - leaf.hung.hinge, leaf.hung.across) > 0 ? 1 : -1;
}

double opening_of(const Leaf& leaf) noexcept {
  return leaf.opens == DoorOpens::Sliding ? leaf.slid : std::abs(leaf.angle);
}

void set_opening(double opening, Leaf& leaf) noexcept {
  if (leaf.opens == DoorOpens::Sliding)
    leaf.slid = opening;
  else
    leaf.angle = std::copysign(opening, leaf.opens == DoorOpens::Pull ? -1 : leaf.angle);
}

bool is_drawn(const Leaf& leaf, Vec2 from) noexcept {
  return leaf.opens == DoorOpens::Sliding ||
         (leaf.opens == DoorOpens::Pull && side_of(leaf, from) < 0);
}

double full_opening(const Leaf& leaf) noexcept {
  constexpr double angle = 1.5, left = 0.02;  // radians, metres
  return leaf.opens == DoorOpens::Sliding ? std::max(0.0, leaf.hung.width - left) : angle;
}

void open_on(double seconds, double speed, Leaf& leaf) noexcept {
  constexpr double gain = 3;
  const double full = full_opening(leaf);
  const double open = opening_of(leaf);
  const double wanted = -std::min(speed, gain * (full - open));  // a rate is of closing
  leaf.rate += std::clamp(wanted - leaf.rate, -gain * seconds, gain * seconds);
  leaf.unused = 0;
  set_opening(std::clamp(open - leaf.rate * seconds, 0.0, full), leaf);
}

}  // namespace docent::guide
