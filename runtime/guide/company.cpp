#include "runtime/guide/company.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace docent {
namespace {

constexpr double longest_lead = 2;       // seconds: a plan is never asked for from later than that
constexpr double go_on_ahead = 1;        // seconds before a stretch ends in which the next is made
constexpr double standing_lead = 0.1;    // seconds: who stands sets out that much after asking
constexpr double ask_again = 0.5;        // seconds, while others are in the way
constexpr double ask_room_again = 2.5;   // seconds between two requests to make room
constexpr double make_room_pause = 2.0;  // seconds before who made room wants to get on itself
constexpr double urgency = 0.2;          // rank gained by a second of being held up
constexpr double appear_again = 1.0;     // seconds, while somebody stands where one shall appear

}  // namespace

bool stands(const Avatar& avatar) noexcept {
  return !avatar.next && avatar.seconds >= avatar.plan->seconds();
}

std::uint32_t Company::add(std::uint32_t floor, const Placement& place, double rank, double pace) {
  const auto who = static_cast<std::uint32_t>(walkers_.size());
  Walker walker;
  walker.avatar = make_avatar(museum_, floor, make_standing(museum_, place));
  walker.rank = rank;
  walker.pace = pace;
  walkers_.push_back(std::move(walker));
  return who;
}

void Company::send(std::uint32_t who, const Placement& goal, RouteKind kind) noexcept {
  Walker& walker = walkers_[who];
  walker.goal = goal;
  walker.kind = kind;
  walker.has_arrived = walker.is_on_its_way = false;
  walker.trip.reset();
  walker.ask_at = clock_;
  walker.awaits_answer = false;
  walker.avatar.next.reset();
  see_to(who);
}

void Company::stop(std::uint32_t who) noexcept {
  Walker& walker = walkers_[who];
  walker.goal.reset();
  walker.has_arrived = true;
  walker.is_on_its_way = false;
  walker.trip.reset();
  walker.avatar.next.reset();
  if (stands(walker.avatar)) return;
  ask(who, {}, walker.avatar.seconds + walker.lead);
}

void Company::ask(std::uint32_t who, WalkOrder order, double takes_over) noexcept {
  Walker& walker = walkers_[who];
  const Avatar& avatar = walker.avatar;
  const Walk& walk = avatar.plan->walk;
  order.id = walker.last_order = ++last_order_;
  order.avatar = who;
  order.floor = avatar.floor;
  order.start = avatar.body;
  order.pace = walker.pace;
  order.before = avatar.plan.get();
  if (!walk.root.empty()) {
    const auto last = static_cast<double>(walk.root.size() - 1);
    const double frame = std::min(std::ceil(takes_over * walk.frame_rate - 1e-6), last);
    order.before_frame = static_cast<std::uint32_t>(frame);
    takes_over =
        frame < last ? frame / walk.frame_rate : std::max(takes_over, avatar.plan->seconds());
  }
  if (walkers_.size() > 1) {
    order.before_seconds = takes_over;
    order.seconds = clock_ + takes_over - avatar.seconds;
    order.held_seconds = walker.held_seconds;
    order.rank = walker.rank + urgency * walker.held_seconds + 1e-6 * who;
  }
  walker.awaits_answer = true;
  planner_.ask(order);
}

void Company::ask_for_room(std::uint32_t who, std::uint32_t for_whom) noexcept {
  Walker& walker = walkers_[who];
  if (walker.awaits_answer || !stands(walker.avatar) ||
      clock_ - walker.asked_for_room < ask_room_again)
    return;
  walker.asked_for_room = clock_;
  walker.is_on_its_way = false;
  WalkOrder order;
  order.makes_room_for = for_whom;
  ask(who, order, walker.avatar.seconds + standing_lead);
}

// What the planner answers.

void Company::take_answers() noexcept {
  while (std::unique_ptr<Plan> plan = planner_.take_plan()) {
    Walker& walker = walkers_[plan->order.avatar];
    if (plan->order.id == walker.last_order) take_answer(walker, std::move(plan));
  }
}

void Company::take_answer(Walker& walker, std::unique_ptr<Plan> plan) noexcept {
  const std::uint32_t who = plan->order.avatar;
  walker.awaits_answer = false;
  for (const std::uint32_t other : plan->in_the_way)
    if (other < walkers_.size()) ask_for_room(other, who);
  if (plan->order.enters) {
    walker.is_here = !plan->holds;
    walker.ask_at = clock_ + appear_again;
    return;
  }
  const bool begins = plan->order.goal && !plan->order.goes_on;
  if (begins) {
    walker.is_answered = true;
    walker.trip = Trip{plan->status, plan->length, plan->seconds_to_goal};
  }
  if (plan->status != RouteStatus::Ok) {
    walker.goal.reset();
    walker.has_arrived = true;
    return;
  }
  if (plan->holds) {
    // Not all at once.
    walker.ask_at = clock_ + ask_again + 0.02 * (who % 8);
    return;
  }
  const bool aside = plan->order.makes_room_for.has_value();
  const bool leads_to_goal = plan->order.goal.has_value();
  if (aside) walker.ask_at = clock_ + plan->seconds() + make_room_pause;
  if (!take_plan(walker.avatar, std::move(plan))) {
    walker.lead = std::min(2 * walker.lead, longest_lead);
    return;  // and asks again
  }
  walker.is_on_its_way = leads_to_goal;
}

// What time brings.

void Company::step(double seconds) noexcept {
  clock_ += seconds;
  for (Walker& walker : walkers_) walker.is_answered = false;
  take_answers();
  for (std::uint32_t who = 0; who < walkers_.size(); ++who) {
    Walker& walker = walkers_[who];
    advance(museum_, walker.avatar, seconds);
    const bool held = walker.goal && !walker.has_arrived && stands(walker.avatar);
    walker.held_seconds = held ? walker.held_seconds + seconds : 0;
    see_to(who);
  }
}

/// Asks for what it needs next, if it is time.
void Company::see_to(std::uint32_t who) noexcept {
  Walker& walker = walkers_[who];
  const Avatar& avatar = walker.avatar;
  if (walkers_.size() == 1) walker.is_here = true;
  if (walker.awaits_answer || avatar.next || clock_ < walker.ask_at) return;
  if (!walker.is_here) {
    WalkOrder order;
    order.enters = true;
    return ask(who, order, avatar.seconds);
  }
  if (!walker.goal || walker.has_arrived) return;
  const double lead = stands(avatar) && walkers_.size() > 1 ? standing_lead : walker.lead;
  WalkOrder order;
  order.goal = walker.goal;
  order.kind = walker.kind;
  if (!walker.is_on_its_way) return ask(who, order, avatar.seconds + lead);
  if (avatar.plan->is_whole) {
    walker.has_arrived = stands(avatar);
    return;
  }
  const double go_on = avatar.plan->go_on_frame / avatar.plan->walk.frame_rate;
  // Who stops on its way looks about when it stands.
  const bool stops = avatar.plan->go_on_frame + 1 >= frame_count(avatar.plan->walk);
  if (stops && !stands(avatar)) return;
  if (go_on - avatar.seconds > go_on_ahead + lead) return;
  order.goes_on = true;
  ask(who, order, std::max(go_on, avatar.seconds + lead));
}

}  // namespace docent
