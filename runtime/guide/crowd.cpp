#include "runtime/guide/crowd.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace docent::guide {
namespace {

constexpr double longest_lead = 2;       // seconds: a plan is never asked for from later than that
constexpr double go_on_ahead = 1;        // seconds before a stretch ends in which the next is made
constexpr double standing_lead = 0.1;    // seconds: who stands sets out that much after asking
constexpr double ask_again = 1;          // seconds, while others are in the way
constexpr double settle = 0.2;           // seconds after an answer before changes are asked about
constexpr double stagger = 0.02;         // seconds between two who would ask at once ...
constexpr std::uint32_t staggered = 8;   // ... of so many
constexpr double ask_room_again = 2.5;   // seconds between two requests to make room
constexpr double content_after = 6;      // seconds of being held up ...
constexpr double close_by = 2;           // ... this near to its goal, metres, after which it stays
constexpr double make_room_pause = 2.0;  // seconds for which who made room lets the other go first
constexpr double urgency = 0.2;          // rank gained by a second of being held up
constexpr double appear_again = 1.0;     // seconds, while somebody stands where one shall appear

/// Nowhere just now, on its way to nothing.
void stop_wishing(Agent& one) noexcept {
  one.is_here = one.boards = one.is_on_its_way = one.awaits_answer = one.replans = false;
  one.goal.reset();
  one.stops_at.reset();
  one.is_diverted = false;
  one.has_arrived = true;
  one.route_summary.reset();
  one.boards_at = 0;
}

}  // namespace

bool stands(const Avatar& avatar) noexcept {
  return !avatar.next && avatar.seconds >= avatar.plan->seconds();
}

bool is_to_be_seen(const Agent& one) noexcept {
  constexpr double same_place = 1e-3;  // metres
  if (one.is_here || one.is_away || !one.appears_at) return one.is_here;
  return one.avatar.floor == one.appears_on &&
         glm::distance(one.avatar.body.position, one.appears_at->position) < same_place;
}

bool is_between_floors(const Agent& one) noexcept {
  if (one.appears_at) return false;
  return one.boards || ride_of(one.avatar) != nullptr;
}

Crowd::Crowd(const Museum& museum, plan::Planner& planner) : museum_(museum), planner_(planner) {
  for (std::uint32_t floor = 0; floor < planner.maps().size(); ++floor)
    proximity_.emplace_back(*planner.maps()[floor], floor, museum.body_radius, planner.avatars());
}

std::size_t Crowd::collisions() const noexcept {
  std::size_t sum = 0;
  for (const Proximity& floor : proximity_) sum += floor.collisions();
  return sum;
}

const plan::Nearby& Crowd::near(std::uint32_t who) const noexcept {
  return proximity_[members_[who].avatar.floor].near(who);
}

std::uint32_t Crowd::add(std::uint32_t floor, const Placement& place, double rank, double pace) {
  const auto who = static_cast<std::uint32_t>(members_.size());
  Agent one;
  one.avatar = make_avatar(museum_, floor, plan::make_standing(museum_, place), who);
  one.rank = rank;
  one.pace = pace;
  members_.push_back(std::move(one));
  return who;
}

void Crowd::appear(std::uint32_t who, std::uint32_t floor, const Placement& place) noexcept {
  Agent& one = members_[who];
  if (std::exchange(one.is_away, false)) --away_;
  one.appears_at = place;
  one.appears_on = floor;
  stop_wishing(one);
  one.ask_at = clock_;
  one.avatar.next.reset();
  ask_for_next(who);
}

void Crowd::leave(std::uint32_t who) noexcept {
  Agent& one = members_[who];
  if (std::exchange(one.is_away, true)) return;
  ++away_;
  stop_wishing(one);
  one.avatar.next.reset();
  plan::WalkOrder order;
  order.leaves = true;
  ask(who, order, one.avatar.seconds);
  one.awaits_answer = false;  // there is none
}

void Crowd::hold_still() noexcept {
  for (Agent& one : members_) one.avatar.breathes = false;
}

void Crowd::send(std::uint32_t who, std::uint32_t floor, const Placement& goal, RouteKind kind,
                 const path::Permissions& permissions,
                 std::optional<std::uint32_t> exhibit) noexcept {
  Agent& one = members_[who];
  one.goal = goal;
  one.goal_floor = floor;
  one.exhibit = exhibit;
  one.seeks.reset();
  one.place = none;
  one.kind = kind;
  one.permissions = permissions;
  set_out(who);
}

void Crowd::seek(std::uint32_t who, PlaceKind place, RouteKind kind,
                 const path::Permissions& permissions) noexcept {
  Agent& one = members_[who];
  one.goal = one.avatar.body;  // until it is known
  one.goal_floor = one.avatar.floor;
  one.exhibit.reset();
  one.seeks = place;
  one.place = none;
  one.kind = kind;
  one.permissions = permissions;
  set_out(who);
}

void Crowd::set_out(std::uint32_t who) noexcept {
  Agent& one = members_[who];
  one.has_arrived = one.is_on_its_way = one.has_ridden = one.is_diverted = false;
  one.stops_at.reset();
  one.route_summary.reset();
  one.ask_at = clock_;
  one.boards_at = 0;
  if (is_between_floors(one)) return;
  one.awaits_answer = false;
  one.avatar.next.reset();
  ask_for_next(who);
}

void Crowd::replan() noexcept {
  for (std::uint32_t who = 0; who < members_.size(); ++who) {
    Agent& one = members_[who];
    if (!one.goal || one.has_arrived) continue;
    if (one.seeks)
      seek(who, *one.seeks, one.kind, one.permissions);
    else
      send(who, one.goal_floor, *one.goal, one.kind, one.permissions, one.exhibit);
    one.replans = true;
  }
}

void Crowd::stop(std::uint32_t who) noexcept {
  Agent& one = members_[who];
  one.goal.reset();
  one.stops_at.reset();
  one.has_arrived = true;
  one.is_on_its_way = one.is_diverted = false;
  one.route_summary.reset();
  one.boards_at = 0;
  if (is_between_floors(one)) return;
  one.avatar.next.reset();
  if (stands(one.avatar)) return;
  ask(who, {}, one.avatar.seconds + one.lead);
}

bool Crowd::is_about_to_arrive(std::uint32_t who) const noexcept {
  const Agent& one = members_[who];
  const Avatar& avatar = one.avatar;
  return can_stop_over(who) && avatar.plan->is_whole && !avatar.plan->then &&
         avatar.floor == one.goal_floor && !stands(avatar);
}

void Crowd::end_at(std::uint32_t who, const Placement& place) noexcept {
  Agent& one = members_[who];
  one.goal = place;
  one.seeks.reset();
  plan::WalkOrder order;
  order.goal = place;
  order.goal_floor = one.goal_floor;
  order.kind = RouteKind::Shortest;
  order.permissions = one.permissions;
  ask(who, order, one.avatar.seconds + one.lead);
}

void Crowd::ask(std::uint32_t who, plan::WalkOrder order, double takes_over) noexcept {
  Agent& one = members_[who];
  const Avatar& avatar = one.avatar;
  const motion::Walk& walk = avatar.plan->walk;
  order.id = one.last_order = ++last_order_;
  order.avatar = who;
  one.surroundings = surroundings_of(who);
  order.floor = order.enters && one.appears_at ? one.appears_on : avatar.floor;
  order.start = order.enters ? one.appears_at.value_or(avatar.body) : avatar.body;
  order.pace = one.pace;
  order.previous = avatar.plan.get();
  if (!walk.root.empty()) {
    const auto last = static_cast<double>(walk.root.size() - 1);
    const double frame = std::min(std::ceil(takes_over * walk.frame_rate - 1e-6), last);
    order.previous_frame = static_cast<std::uint32_t>(frame);
    takes_over =
        frame < last ? frame / walk.frame_rate : std::max(takes_over, avatar.plan->seconds());
  }
  if (is_company()) {
    order.previous_seconds = takes_over;
    order.seconds = clock_ + takes_over - avatar.seconds;
    order.near = near(who);
    order.blocked_seconds = one.blocked_seconds;
    order.rank = one.rank + urgency * one.blocked_seconds + 1e-6 * who;
  }
  one.awaits_answer = true;
  planner_.ask(order);
}

void Crowd::ask_for_room(std::uint32_t who, std::uint32_t for_whom) noexcept {
  Agent& one = members_[who];
  if (one.awaits_answer || !stands(one.avatar) || is_between_floors(one) ||
      clock_ - one.asked_for_room < ask_room_again)
    return;
  one.asked_for_room = clock_;
  one.is_on_its_way = false;
  plan::WalkOrder order;
  order.makes_room_for = for_whom;
  ask(who, order, one.avatar.seconds + standing_lead);
}

// What the planner answers.

void Crowd::take_answers() noexcept {
  while (std::unique_ptr<plan::Plan> plan = planner_.take_plan()) {
    Agent& one = members_[plan->order.avatar];
    if (plan->order.id == one.last_order) take_answer(one, std::move(plan));
  }
}

void Crowd::take_answer(Agent& one, std::unique_ptr<plan::Plan> plan) noexcept {
  const std::uint32_t who = plan->order.avatar;
  one.awaits_answer = false;
  for (const std::uint32_t other : plan->in_the_way)
    if (other < members_.size()) ask_for_room(other, who);
  if (plan->order.enters) return take_appearance(one, std::move(plan));
  if (plan->order.ride) return take_ride(one, std::move(plan));
  if (plan->place != none) {
    one.place = plan->place;
    one.goal = plan->order.goal;
    one.goal_floor = plan->order.goal_floor.value_or(plan->order.floor);
  }
  if (one.stops_at) return take_stop_over(one, std::move(plan));
  // Who goes on from a stop goes the way that was told before.
  const bool goes_on = one.is_diverted && plan->status == path::RouteStatus::Ok;
  if (plan->order.goal && (!plan->order.continues || plan->is_new_way) && !goes_on) {
    one.is_answered = true;
    // What was told of the whole way stays true on its later floors.
    if (!one.has_ridden || plan->status != path::RouteStatus::Ok)
      one.route_summary = interface::RouteSummary{plan->status, plan->length, plan->seconds_to_goal,
                                                  plan->hindrance};
  }
  const bool replans = std::exchange(one.replans, false);
  if (plan->status != path::RouteStatus::Ok) {
    one.goal.reset();
    one.has_arrived = true;
    if (!replans) return;
    const auto summary = one.route_summary;  // of no way: it goes on no farther on the old one
    stop(who);
    one.route_summary = summary;
    return;
  }
  if (plan->holds) {
    const double turn = stagger * (who % staggered);
    one.ask_at = clock_ + ask_again + turn;
    one.ask_again_at = clock_ + settle + turn;
    return;
  }
  const bool aside = plan->order.makes_room_for.has_value();
  const bool leads_to_goal = plan->order.goal.has_value();
  one.made_room_for = plan->order.makes_room_for;
  if (aside) one.let_first_until = clock_ + plan->seconds() + make_room_pause;
  if (!take_plan(one.avatar, std::move(plan))) {
    one.lead = std::min(2 * one.lead, longest_lead);
    return;  // and asks again
  }
  ++one.commitments;
  one.is_on_its_way = leads_to_goal;
  one.is_diverted = false;
}

/// Where there is no way to the stop it does not stop.
void Crowd::take_stop_over(Agent& one, std::unique_ptr<plan::Plan> plan) noexcept {
  const std::uint32_t who = plan->order.avatar;
  one.made_room_for = plan->order.makes_room_for;
  if (one.made_room_for) {
    one.let_first_until = clock_ + plan->seconds() + make_room_pause;
    one.is_on_its_way = false;
  }
  if (plan->status != path::RouteStatus::Ok) {
    one.stops_at.reset();
    return;
  }
  if (plan->holds) {
    one.ask_at = clock_ + ask_again + stagger * (who % staggered);
    one.ask_again_at = clock_ + settle;
    return;
  }
  const bool leads_there = plan->order.goal.has_value();
  // What is left of its way after the stop, as told by the plan that it leaves for it.
  const plan::Plan& before = *one.avatar.plan;
  const double left = before.reach.empty() ? 0 : before.reach.back() - one.avatar.along;
  const double there = plan->reach.empty() ? 0 : plan->reach.back();
  plan->beyond = std::max(0.0, left + before.beyond - there);
  plan->metres_after = before.metres_after;
  plan->seconds_after = before.seconds_after;
  if (!take_plan(one.avatar, std::move(plan))) {
    one.lead = std::min(2 * one.lead, longest_lead);
    return;
  }
  ++one.commitments;
  one.is_on_its_way = one.is_diverted = leads_there;
}

void Crowd::take_appearance(Agent& one, std::unique_ptr<plan::Plan> plan) noexcept {
  one.is_here = !plan->holds;
  one.ask_at = clock_ + appear_again;
  if (!one.is_here || !one.appears_at) return;
  one.ask_at = clock_;
  one.appears_at.reset();
  one.avatar.floor = plan->order.floor;
  one.avatar.seconds = one.avatar.along = 0;
  one.avatar.next.reset();
  one.avatar.plan = std::move(plan);
  ++one.commitments;
}

/// Where it cannot get on yet, it asks again; whatever it has been told since, it rides once it has
/// a ride, because its place on this floor is no longer kept for it.
void Crowd::take_ride(Agent& one, std::unique_ptr<plan::Plan> plan) noexcept {
  one.boards = !plan->holds;
  if (plan->holds) {
    one.ask_at = clock_ + ask_again;
    return;
  }
  plan->order.previous_seconds = std::max(plan->order.previous_seconds, one.avatar.seconds);
  if (!take_plan(one.avatar, std::move(plan))) return;
  ++one.commitments;
  one.has_ridden = true;
  one.is_on_its_way = false;
  one.boards_at = 0;
}

// What time brings.

void Crowd::step(double seconds) noexcept {
  clock_ += seconds;
  for (Agent& one : members_) one.is_answered = false;
  take_answers();
  for (Agent& one : members_)
    if (!one.is_away) advance(museum_, one.avatar, seconds);
  for (Proximity& floor : proximity_) floor.look(members_, seconds);
  for (std::uint32_t who = 0; who < members_.size(); ++who) {
    Agent& one = members_[who];
    // It is on its ride, or past it where the step was long, or came too late to get on.
    if (one.boards && !one.awaits_answer && !one.avatar.next) one.boards = false;
    const bool held = one.goal && !one.has_arrived && stands(one.avatar) && !stands_over(who);
    one.blocked_seconds = held ? one.blocked_seconds + seconds : 0;
    ask_for_next(who);
  }
}

/// Is the one for whom it has made room still there?
bool Crowd::yields(const Agent& one) const noexcept {
  if (!one.made_room_for || clock_ >= one.let_first_until) return false;
  const Agent& other = members_[*one.made_room_for];
  return other.goal && !other.has_arrived && stands(other.avatar);
}

/// A number that changes when somebody near comes, goes or takes another plan.
std::uint64_t Crowd::surroundings_of(std::uint32_t who) const noexcept {
  constexpr std::uint64_t spread = 0x9e3779b97f4a7c15U;  // of bits; 2^64 by the golden ratio
  std::uint64_t sum = 0;
  for (const std::uint32_t other : near(who).agents())
    sum += (other + 1) * spread ^ members_[other].commitments * (spread >> 1);
  return sum;
}

/// Is it time to ask, or has something changed since it asked?
bool Crowd::may_ask(std::uint32_t who) const noexcept {
  const Agent& one = members_[who];
  if (clock_ >= one.ask_at) return true;
  return one.is_here && clock_ >= one.ask_again_at && surroundings_of(who) != one.surroundings;
}

/// Asks for what it needs next, if it is time.
void Crowd::ask_for_next(std::uint32_t who) noexcept {
  Agent& one = members_[who];
  const Avatar& avatar = one.avatar;
  if (one.is_away) return;
  if (!is_company() && !one.appears_at) one.is_here = true;
  if (one.awaits_answer || avatar.next || !may_ask(who) || yields(one)) return;
  if (!one.is_here) {
    plan::WalkOrder order;
    order.enters = true;
    return ask(who, order, avatar.seconds);
  }
  if (is_between_floors(one) || !one.goal || one.has_arrived) return;
  go_on(who);
}

/// To its goal, or to where it stops before.
plan::WalkOrder Crowd::order_of(const Agent& one) const noexcept {
  plan::WalkOrder order;
  order.permissions = one.permissions;
  if (one.stops_at) {
    order.goal = one.stops_at;
    order.goal_floor = one.avatar.floor;
    return order;
  }
  order.goal = one.goal;
  order.goal_floor = one.goal_floor;
  order.exhibit = one.exhibit;
  if (one.place == none) order.seeks = one.seeks;
  order.kind = one.kind;
  return order;
}

/// On the way to its goal.
void Crowd::go_on(std::uint32_t who) noexcept {
  Agent& one = members_[who];
  const Avatar& avatar = one.avatar;
  if (one.blocked_seconds > content_after && avatar.floor == one.goal_floor &&
      glm::distance(avatar.body.position, one.goal->position) < close_by)
    one.goal->position = avatar.body.position;  // somebody holds the place itself
  const double lead = stands(avatar) && is_company() ? standing_lead : one.lead;
  plan::WalkOrder order = order_of(one);
  if (!one.is_on_its_way || one.is_diverted != one.stops_at.has_value())
    return ask(who, order, avatar.seconds + lead);
  if (avatar.plan->is_whole) {
    if (one.is_diverted) return;  // until it is to go on
    if (avatar.plan->then) return ask_for_ride(who);
    one.has_arrived = stands(avatar);
    return;
  }
  const double handover = avatar.plan->handover_frame / avatar.plan->walk.frame_rate;
  // Who stops on its way does so because of others.
  const bool stops = avatar.plan->handover_frame + 1 >= motion::frame_count(avatar.plan->walk);
  order.continues = true;
  if (stops && !stands(avatar)) {
    if (clock_ < one.ask_again_at || surroundings_of(who) == one.surroundings) return;
    one.ask_again_at = clock_ + ask_again;
    return ask(who, order, avatar.seconds + lead);
  }
  if (handover - avatar.seconds > go_on_ahead + lead) return;
  ask(who, order, std::max(handover, avatar.seconds + lead));
}

/// Stands at a stop, waits as one waits there, and gets on.
void Crowd::ask_for_ride(std::uint32_t who) noexcept {
  Agent& one = members_[who];
  const Avatar& avatar = one.avatar;
  if (!stands(avatar)) return;
  if (one.boards_at == 0) one.boards_at = clock_ + avatar.plan->then->wait;
  if (clock_ < one.boards_at) return;
  plan::WalkOrder order;
  order.ride = avatar.plan->then;
  one.boards = true;
  ask(who, order, avatar.seconds + (is_company() ? standing_lead : 0));
}

}  // namespace docent::guide
