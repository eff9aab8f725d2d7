#include "runtime/plan/lead_through_doors.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "runtime/model/geometry/hung_leaf.h"
#include "runtime/model/geometry/polyline.h"
#include "runtime/model/geometry/segment.h"
#include "runtime/plan/care.h"

namespace docent::plan {
namespace {

constexpr double straight = 0.5;  ///< Metres before a door that are walked straight, ...
/// ... by who has stood beside it to pull it open, ...
constexpr double short_straight = 0.05, longer_straight = 0.15, longest_of_these = 0.3;
constexpr double beside_it = 1.5;         ///< ... so many metres of the way before it.
constexpr double beside_free_end = 0.06;  ///< ... and leaves so much room beside its free end.
constexpr double past_leaf = 0.2;         ///< ... and beyond the end of an open leaf behind it.
constexpr std::array leaves_way_by{1.6, 1.2, 0.9, 2.2,
                                   3.0};  ///< Metres before, and likewise after.

/// Where one goes through, and in which direction: along the door's own `across`, or against it.
struct Passing {
  double along = 0;  ///< Metres of the way.
  Vec2 at{}, ahead{};
  double width = 1;  ///< Metres, of a leaf.
  bool is_pulled = false, slides = false;
  Vec2 free_end{};  ///< Of the leaf, where it is closed: a jamb, or another leaf.
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
    const double side = dot(way[i] - way[i - 1], leaves.leaf[0].across) > 0 ? 1 : -1;
    const bool is_pulled = door.opens == DoorOpens::Pull && side > 0;
    // With two leaves between both; with one a little nearer to its free end. Of two that are
    // pulled one is enough.
    const bool both = leaves.count == 2 && !(is_pulled && is_wide_enough(leaves.leaf[1]));
    const HungLeaf& hung = leaves.leaf[both ? 0 : leaves.count - 1];
    return Passing{.along = along + glm::distance(way[i - 1], *at),
                   .at = hung.hinge + (both ? 1 : 0.53) * hung.width * hung.along,
                   .ahead = side * hung.across,
                   .width = hung.width,
                   .is_pulled = is_pulled,
                   .slides = door.opens == DoorOpens::Sliding,
                   .free_end = hung.hinge + hung.width * hung.along};
  }
  return {};
}

/// The way with its part about the passing replaced; nothing where a wall is in the way.
std::optional<std::vector<Vec2>> led_through(std::span<const Vec2> way, const path::FloorMap& map,
                                             const Passing& passing, double straight_before,
                                             double straight_behind, double radius) {
  const double length = polyline_length(way);
  const Vec2 before = passing.at - straight_before * passing.ahead;
  const Vec2 behind = passing.at + straight_behind * passing.ahead;
  if (!map.walls().capsule_clear(before, behind, radius)) return {};
  // Where it leaves the way, and where it is back on it.
  const auto joint = [&](double direction, Vec2 end) -> std::optional<double> {
    for (const double metres : leaves_way_by) {
      const double at = std::clamp(passing.along + direction * metres, 0.0, length);
      const Vec2 place = docent::point_along(way, at);
      if (direction * dot(place - end, passing.ahead) > -0.05 &&
          map.walls().capsule_clear(place, end, radius) &&
          (!passing.is_pulled ||
           distance_to_segment(passing.free_end, place, end) > radius + beside_free_end))
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
    const bool begins_beside = passing->is_pulled && passing->along < beside_it;
    const bool pushes = !passing->is_pulled && !passing->slides;
    // A leaf that comes towards them by itself stands in the way of who comes from its side.
    const double swept = passing->is_pulled ? passing->width + past_leaf : straight;
    const double before = begins_beside ? short_straight : swept;
    const double farther = begins_beside ? longer_straight : straight;
    const double farthest = begins_beside ? longest_of_these : straight;
    const double behind = pushes ? passing->width + past_leaf : straight;
    for (const auto& [in, out] :
         {std::pair{before, behind}, std::pair{farther, behind}, std::pair{farthest, behind},
          std::pair{straight, behind}, std::pair{straight, straight}}) {
      auto other = led_through(led, map, *passing, in, out, museum.body_radius);
      if (!other) continue;
      led = std::move(*other);
      break;
    }
  }
  return led;
}

}  // namespace docent::plan
