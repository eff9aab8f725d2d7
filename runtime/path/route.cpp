#include "runtime/path/route.h"

#include <algorithm>
#include <cmath>

#include "runtime/path/floor_map.h"
#include "runtime/path/join_ways.h"
#include "runtime/path/make_tangent_graph.h"
#include "runtime/path/medial_axis_way.h"
#include "runtime/path/offset_way.h"

namespace docent {
namespace {

Way shortest(const FloorMap& map, const RouteQuery& query) {
  Way way = shortest_way(*map.shortest_ways(query.radius), query.from, query.to);
  if (way.status == RouteStatus::Ok && way.points.size() == 2)
    way.clearance_min = map.walls().segment_clearance(
        query.from, query.to, std::min(map.clearance_at(query.from), map.clearance_at(query.to)));
  return way;
}

}  // namespace

std::shared_ptr<const FloorMap> make_floor_map(const Floor& floor) {
  return std::make_shared<const FloorMap>(floor);
}

Way route(const FloorMap& map, const RouteQuery& asked) {
  RouteQuery query = asked;
  if (!(query.radius >= smallest_radius)) query.radius = 0;
  if (!map.has_room(query.from, query.radius)) return {.status = RouteStatus::StartBlocked};
  if (!map.has_room(query.to, query.radius)) return {.status = RouteStatus::GoalBlocked};
  switch (query.kind) {
    case RouteKind::Shortest:
      return shortest(map, query);
    case RouteKind::Skeleton:
      return medial_axis_way(map, query);
    case RouteKind::Offset:
      return offset_way(map, query);
  }
  return {};
}

Way tour(const FloorMap& map, const RouteQuery& asked, std::span<const Vec2> stops) {
  RouteQuery query = asked;
  if (!(query.radius >= smallest_radius)) query.radius = 0;
  if (stops.empty()) return {.status = RouteStatus::StartBlocked};
  for (std::size_t i = 0; i < stops.size(); ++i)
    if (!map.has_room(stops[i], query.radius))
      return {.status = i == 0 ? RouteStatus::StartBlocked : RouteStatus::GoalBlocked};
  if (query.kind == RouteKind::Offset && stops.size() > 1) return offset_tour(map, query, stops);
  Way whole{RouteStatus::Ok, 0, map.clearance_at(stops[0]), {stops[0]}};
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    query.from = stops[i];
    query.to = stops[i + 1];
    const Way leg = route(map, query);
    if (leg.status != RouteStatus::Ok) return leg;
    join(whole, leg);
  }
  return whole;
}

double clearance_at(const FloorMap& map, Vec2 point) noexcept {
  return map.clearance_at(point);
}
bool is_inside(const FloorMap& map, Vec2 point) noexcept {
  return map.is_inside(point);
}
bool can_see(const FloorMap& map, Vec2 from, Vec2 to) noexcept {
  return map.walls().segment_clear(from, to);
}
std::uint32_t region_at(const FloorMap& map, Vec2 point) noexcept {
  return map.site_at(point);
}

}  // namespace docent
