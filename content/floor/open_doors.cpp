#include "content/floor/open_doors.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/model/geometry/polygon.h"

namespace docent::floor {
namespace {

/// How far a doorway reaches into the floor on either side, so that rounding leaves no slit.
/// Metres.
constexpr double overlap = 0.01;

bool is_floor(const import::ImportedPlan& plan, Vec2 p) {
  return std::ranges::any_of(plan.polygons, [&](const import::ImportedPolygon& polygon) {
    return contains(polygon.outer.vertex, p) &&
           std::ranges::none_of(polygon.holes, [&](const import::ImportedRing& hole) {
             return contains(hole.vertex, p);
           });
  });
}

/// How far it is to the floor, going that way.
std::optional<double> to_floor(const import::ImportedPlan& plan, Vec2 from, Vec2 way) {
  constexpr double step = 0.005;
  for (double away = step; away <= thickest_opened; away += step)
    if (is_floor(plan, from + away * way)) return away;
  return std::nullopt;
}

}  // namespace

void open_doors(import::ImportedPlan& plan, std::span<const Door> doors) {
  if (plan.polygons.empty()) return;
  std::vector<import::ImportedPolygon> doorways;
  for (const Door& door : doors) {
    const Vec2 middle = 0.5 * (door.a + door.b);
    if (door.a == door.b || is_floor(plan, middle)) continue;
    const Vec2 across = left_of(glm::normalize(door.b - door.a));
    const auto left = to_floor(plan, middle, across), right = to_floor(plan, middle, -across);
    if (!left || !right || *left + *right > thickest_opened) continue;
    const Vec2 one = (*left + overlap) * across, other = -(*right + overlap) * across;
    import::ImportedRing ring{{door.a + other, door.b + other, door.b + one, door.a + one}, {}};
    ring.place.assign(ring.vertex.size(), plan.polygons.front().outer.place.front());
    doorways.push_back({std::move(ring), {}, true});
  }
  std::ranges::move(doorways, std::back_inserter(plan.polygons));
}

}  // namespace docent::floor
