// Who stops on their way, to go on later.

#include <algorithm>

#include "runtime/guide/crowd.h"
#include "runtime/model/none.h"

namespace docent::guide {

bool Crowd::can_stop_over(std::uint32_t who) const noexcept {
  const Agent& one = members_[who];
  return one.goal && !one.has_arrived && one.is_on_its_way && !one.awaits_answer &&
         !one.avatar.next && !is_between_floors(one) && !one.stops_at && !one.is_diverted;
}

void Crowd::stop_over(std::uint32_t who, const Placement& place) noexcept {
  Agent& one = members_[who];
  one.stops_at = place;
  ask(who, order_of(one), one.avatar.seconds + one.lead);
}

void Crowd::go_on_from_stop(std::uint32_t who) noexcept {
  Agent& one = members_[who];
  if (!one.stops_at) return;
  one.stops_at.reset();
  if (is_between_floors(one) || !one.goal) return;
  // What it was asked to walk to the stop is no longer wanted.
  one.last_order = ++last_order_;
  one.awaits_answer = false;
  one.avatar.next.reset();
  one.is_diverted = true;
  one.ask_at = clock_;
}

double Crowd::seconds_to_stop(std::uint32_t who) const noexcept {
  const Agent& one = members_[who];
  if (!one.stops_at || !one.is_diverted || !one.is_on_its_way || one.awaits_answer ||
      one.avatar.next || !one.avatar.plan->is_whole)
    return infinity;
  return std::max(0.0, one.avatar.plan->seconds() - one.avatar.seconds);
}

bool Crowd::stands_over(std::uint32_t who) const noexcept {
  return seconds_to_stop(who) == 0;
}

bool Crowd::is_clear(std::uint32_t floor, Vec2 from, Vec2 to, double radius) const noexcept {
  return floor < planner_.maps().size() &&
         planner_.maps()[floor]->walls().capsule_clear(from, to, radius);
}

bool Crowd::has_room(std::uint32_t floor, Vec2 place, double radius) const noexcept {
  return floor < planner_.maps().size() && planner_.maps()[floor]->has_room(place, radius);
}

}  // namespace docent::guide
