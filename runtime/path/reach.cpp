#include "runtime/path/reach.h"

#include <algorithm>
#include <utility>

namespace docent::path {
namespace {

/// All places by their distance in a straight line, which no way beats. Places that are no numbers
/// are left out.
std::vector<Reached> by_straight_distance(Vec2 from, std::span<const Vec2> places, double limit) {
  std::vector<Reached> found;
  for (std::uint32_t i = 0; i < places.size(); ++i)
    if (const double straight = glm::distance(from, places[i]); straight <= limit)
      found.push_back({i, straight});
  std::ranges::stable_sort(found, {}, &Reached::length);
  return found;
}

std::optional<double> walking_distance(const FloorMap& map, Vec2 from, Vec2 to, double radius) {
  const Way way = route(map, {.from = from, .to = to, .radius = radius});
  if (way.status != RouteStatus::Ok) return {};
  return way.length;
}

}  // namespace

std::vector<Reached> places_in_reach(const FloorMap& map, Vec2 from, std::span<const Vec2> places,
                                     double radius, double limit) {
  std::vector<Reached> reached;
  for (const Reached& near : by_straight_distance(from, places, limit)) {
    const auto length = walking_distance(map, from, places[near.place], radius);
    if (length && *length <= limit) reached.push_back({near.place, *length});
  }
  std::ranges::sort(reached, {}, [](const Reached& r) { return std::pair(r.length, r.place); });
  return reached;
}

std::optional<Reached> nearest_place(const FloorMap& map, Vec2 from, std::span<const Vec2> places,
                                     double radius, double limit) {
  std::optional<Reached> best;
  for (const Reached& near : by_straight_distance(from, places, limit)) {
    if (best && near.length > best->length) break;
    const auto length = walking_distance(map, from, places[near.place], radius);
    if (!length || *length > limit) continue;
    if (!best || std::pair(*length, near.place) < std::pair(best->length, best->place))
      best = Reached{near.place, *length};
  }
  return best;
}

}  // namespace docent::path
