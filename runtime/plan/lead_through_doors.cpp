#include "runtime/plan/lead_through_doors.h"

#include <algorithm>
#include <array>
#include <optional>

#include "runtime/model/geometry/hung_leaf.h"
#include "runtime/model/geometry/polyline.h"
#include "runtime/plan/care.h"

namespace docent::plan {
namespace {

constexpr double straight = 0.5;   ///< Metres before a door that are walked straight, ...
constexpr double past_leaf = 0.2;  ///< ... and beyond the end of an open leaf behind it.
constexpr std::array leaves_way_by{1.6, 1.2, 0.9, 2.2,
                                   3.0};  ///< Metres before, and likewise after.

/// Where one goes through, and in which direction: along the door's own `across`, or against it.
struct Passing {
  double along = 0;  ///< Metres of the way.
  Vec2 at{}, ahead{};
  double width = 1;  ///< Metres, of a leaf.
};

std::optional<Passing> find_passing(std::span<const Vec2> way, const FloorPlan& plan,
                                    const Door& door) {
  const HungLeaves leaves = leaves_of(plan, door);
  if (leaves.count == 0) return {};
  double along = 0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const auto at = crossing(way[i - 1], way[i], door);
    if (!at) {
      along += glm::distance(way[i - 1], way[i]);
      continue;
    }
    const HungLeaf& hung = leaves.leaf[0];
    // With two leaves between both; with one a little nearer to its free end.
    const double share = leaves.count == 2 ? 1 : 0.53;
    const double side = dot(way[i] - way[i - 1], hung.across) > 0 ? 1 : -1;
    return Passing{.along = along + glm::distance(way[i - 1], *at),
                   .at = hung.hinge + share * hung.width * hung.along,
                   .ahead = side * hung.across,
                   .width = hung.width};
  }
  return {};
}

/// The way with its part about the passing replaced; nothing where a wall is in the way.
std::optional<std::vector<Vec2>> led_through(std::span<const Vec2> way, const path::FloorMap& map,
                                             const Passing& passing, double straight_behind,
                                             double radius) {
  const double length = polyline_length(way);
  const Vec2 before = passing.at - straight * passing.ahead;
  const Vec2 behind = passing.at + straight_behind * passing.ahead;
  if (!map.walls().capsule_clear(before, behind, radius)) return {};
  // Where it leaves the way, and where it is back on it.
  const auto joint = [&](double direction, Vec2 end) -> std::optional<double> {
    for (const double metres : leaves_way_by) {
      const double at = std::clamp(passing.along + direction * metres, 0.0, length);
      const Vec2 place = docent::point_along(way, at);
      if (direction * dot(place - end, passing.ahead) > -0.05 &&
          map.walls().capsule_clear(place, end, radius))
        return at;
      if (at == 0 || at == length) break;
    }
    return {};
  };
  const std::optional<double> leaves = joint(-1, before), joins = joint(1, behind);
  if (!leaves || !joins) return {};
  std::vector<Vec2> led = first_part(way, *leaves);
  led.push_back(before);
  led.push_back(behind);
  const std::vector<Vec2> rest = last_part(way, *joins);
  led.insert(led.end(), rest.begin(), rest.end());
  return led;
}

}  // namespace

std::vector<Vec2> lead_through_doors(const Museum& museum, const path::FloorMap& map,
                                     std::span<const Vec2> way) {
  std::vector<Vec2> led(way.begin(), way.end());
  for (const Door& door : map.plan().doors) {
    if (door.closed) continue;
    const auto passing = find_passing(led, map.plan(), door);
    if (!passing) continue;
    for (const double behind : {passing->width + past_leaf, straight}) {
      auto other = led_through(led, map, *passing, behind, museum.body_radius);
      if (!other) continue;
      led = std::move(*other);
      break;
    }
  }
  return led;
}

}  // namespace docent::plan
