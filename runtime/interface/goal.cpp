#include "runtime/interface/goal.h"

#include <cmath>

namespace docent::interface {

bool has_goal(const InterfaceState& state) noexcept {
  return state.exhibit || state.place || state.seeks;
}

Placement standing_at(const Place& place) noexcept {
  const Vec2 gap = place.position - place.standing;
  return {place.standing, dot(gap, gap) > 1e-6 ? std::atan2(gap.y, gap.x) : 0};
}

std::optional<Goal> goal_of(const Museum& museum, const InterfaceState& state) noexcept {
  if (state.exhibit && *state.exhibit < museum.exhibits.size()) {
    const Exhibit& exhibit = museum.exhibits[*state.exhibit];
    return Goal{exhibit.floor, exhibit.viewing_point, exhibit.placement.position};
  }
  if (state.place && *state.place < museum.places.size()) {
    const Place& place = museum.places[*state.place];
    return Goal{place.floor, standing_at(place), place.position};
  }
  return {};
}

}  // namespace docent::interface
