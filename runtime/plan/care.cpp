#include "runtime/plan/care.h"

#include <algorithm>
#include <cmath>

#include "runtime/model/geometry/polyline.h"

namespace docent::plan {
namespace {

/// Before a leaf one walks slowly enough for a hand to find the handle and the leaf to turn; a
/// doorway without one, and stairs, are only looked at.
constexpr motion::CarefulPlace leaf{.radius = 0.95, .share = 0.55};
constexpr motion::CarefulPlace doorway{.radius = 0.6, .share = 0.85};
constexpr motion::CarefulPlace stairs{.radius = 1.0, .share = 0.8};

motion::CarefulPlace placed(motion::CarefulPlace care, Vec2 at) {
  care.at = at;
  return care;
}

}  // namespace

std::optional<Vec2> crossing(Vec2 p, Vec2 q, const Door& door) noexcept {
  const Vec2 run = q - p, along = door.b - door.a;
  const double across = cross(run, along);
  if (across == 0) return {};
  const double share = cross(door.a - p, along) / across, of_door = cross(door.a - p, run) / across;
  if (share < 0 || share > 1 || of_door < 0 || of_door > 1) return {};
  return p + share * run;
}

std::vector<motion::CarefulPlace> careful_places(const Museum& museum, const Plan& plan) {
  std::vector<motion::CarefulPlace> places;
  if (plan.order.floor >= museum.floors.size()) return places;
  for (const Door& door : museum.floors[plan.order.floor].plan.doors) {
    if (door.closed) continue;
    for (std::size_t i = 1; i < plan.points.size(); ++i)
      if (const auto at = crossing(plan.points[i - 1], plan.points[i], door))
        places.push_back(placed(door.opens == DoorOpens::None ? doorway : leaf, *at));
  }
  if (plan.then && museum.connections[plan.then->connection].kind == ConnectionKind::Stairs)
    places.push_back(placed(stairs, plan.end.position));
  return places;
}

double seconds_of_care(std::span<const motion::CarefulPlace> places, std::span<const Vec2> way,
                       double speed) {
  constexpr double step = 0.05;  // metres
  if (places.empty() || way.size() < 2) return 0;
  double seconds = 0;
  const double length = polyline_length(way);
  for (double along = step / 2; along < length; along += step) {
    const Vec2 at = docent::point_along(way, along);
    double share = 1;
    for (const motion::CarefulPlace& place : places)
      if (glm::distance(at, place.at) < place.radius) share = std::min(share, place.share);
    seconds += step / speed * (1 / share - 1);
  }
  return seconds;
}

}  // namespace docent::plan
