#include "runtime/crowd/find_detour.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "runtime/model/geometry/polyline.h"
#include "runtime/path/floor_map.h"

namespace docent::crowd {
namespace {

constexpr double detour_spare = 0.1;      // metres kept from who stands
constexpr std::size_t most_places = 400;  // that are tried

}  // namespace

path::Way find_detour(const path::FloorMap& map, const ReservationTable& reservations,
                      std::uint32_t body, const path::RouteQuery& query, double seconds) {
  std::vector<Vec2> standing;
  for (const ReservationTable::Entry& entry : reservations.entries())
    if (entry.body != body && entry.trajectory.end() <= seconds)
      standing.push_back(entry.trajectory.place.back());
  const double apart = 2 * reservations.body_radius() + detour_spare;
  const auto is_free = [&](const path::Way& way) {
    return std::ranges::all_of(
        standing, [&](Vec2 place) { return distance_to_polyline(place, way.points) >= apart; });
  };

  const Roadmap& roads = map.floor().roadmap;
  std::vector<std::pair<double, Vec2>> places;
  for (std::size_t i = 0; i < roads.position.size(); ++i)
    if (const Vec2 place = roads.position[i]; roads.clearance[i] >= query.radius)
      places.emplace_back(glm::distance(query.from, place) + glm::distance(place, query.to), place);
  std::ranges::sort(places, {}, &std::pair<double, Vec2>::first);
  if (places.size() > most_places) places.resize(most_places);

  path::Way best;
  for (const auto& [at_least, place] : places) {
    if (best.status == path::RouteStatus::Ok && at_least >= best.length) break;
    path::RouteQuery first = query, second = query;
    first.to = second.from = place;
    path::Way there = path::route(map, first);
    if (there.status != path::RouteStatus::Ok || !is_free(there)) continue;
    const path::Way on = path::route(map, second);
    if (on.status != path::RouteStatus::Ok || !is_free(on)) continue;
    there.length += on.length;
    if (best.status == path::RouteStatus::Ok && there.length >= best.length) continue;
    there.clearance_min = std::min(there.clearance_min, on.clearance_min);
    there.points.insert(there.points.end(), on.points.begin() + 1, on.points.end());
    best = std::move(there);
  }
  return best;
}

}  // namespace docent::crowd
