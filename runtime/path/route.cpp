#include "runtime/path/route.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "runtime/path/closure/closed_doors.h"
#include "runtime/path/floor_map.h"
#include "runtime/path/join_ways.h"
#include "runtime/path/medial_axis/medial_axis_way.h"
#include "runtime/path/offset/offset_way.h"
#include "runtime/path/round_corners.h"
#include "runtime/path/shortest/make_tangent_graph.h"
#include "runtime/path/shortest/shortest_way.h"

namespace docent::path {
namespace {

/// Do closed doors leave a point room?
bool leaves_room(const RouteQuery& query, Vec2 point) noexcept {
  return query.closed == nullptr || query.closed->has_room(point, query.radius);
}

/// Is a way of the floor with all doors open perhaps none with those closed? If not, it is the best
/// of these too: closing takes ways away and gives none.
bool is_in_doubt(const RouteQuery& query, const Way& way) noexcept {
  return query.closed != nullptr && way.status == RouteStatus::Ok &&
         query.closed->may_block(way.points, query.radius);
}

/// Where a point touches a wall from behind, exact predicates see that wall between it and the
/// floor, and what lies beyond the floor before it: then its ways begin just inside.
Way find_shortest(const FloorMap& map, const RouteQuery& asked) {
  RouteQuery query = asked;
  const auto ways = map.shortest_ways().find(query.radius);
  const auto fit_at = [&](Vec2 point) {
    return ways && ways->surely_has_room(point) ? Fit::Inside : map.fit_at(point, query.radius);
  };
  const auto see = [&]() -> std::optional<Way> {
    if (!ways || !ways->walls().cell_at(query.to)) return {};  // no place, or off the floor's grid
    return straight_way(*ways, query.from, query.to);
  };
  const auto search = [&] {
    return search_tangents(map.search(), query.radius, query.from, query.to, query.closed);
  };
  const Fit start = fit_at(query.from);
  if (start == Fit::None || !leaves_room(query, query.from))
    return {.status = RouteStatus::StartBlocked};
  if (start == Fit::Behind) query.from = map.walls().brought_inside(query.from);
  std::optional<Way> straight = see();
  // What a point sees of the interior is inside.
  if (!straight || query.radius > 0) {
    const Fit goal = fit_at(query.to);
    if (goal == Fit::None) return {.status = RouteStatus::GoalBlocked};
    if (goal == Fit::Behind) {
      query.to = map.walls().brought_inside(query.to);
      straight = see();
    }
  }
  if (!leaves_room(query, query.to)) return {.status = RouteStatus::GoalBlocked};
  Way way = straight ? *std::move(straight)
            : ways   ? bent_way(*ways, query.from, query.to)
                     : search();
  if (ways && is_in_doubt(query, way)) way = search();
  if (way.status != RouteStatus::Ok) return way;
  way.points.front() = asked.from;
  way.points.back() = asked.to;
  if (way.points.size() > 2) return way;
  way.clearance_min = query.radius;
  if (query.tell_clearance)
    way.clearance_min = map.walls().segment_clearance(
        query.from, query.to, std::min(map.clearance_at(query.from), map.clearance_at(query.to)));
  if (query.tell_clearance && query.closed != nullptr)
    way.clearance_min = std::min(way.clearance_min, query.closed->distance(query.from, query.to));
  return way;
}

/// A way along curves that the floor has, where both ends have room, with its corners as asked.
template <Way (*along_curves)(const FloorMap&, const RouteQuery&)>
Way find_along(const FloorMap& map, const RouteQuery& query) {
  if (!map.has_room(query.from, query.radius) || !leaves_room(query, query.from))
    return {.status = RouteStatus::StartBlocked};
  if (!map.has_room(query.to, query.radius) || !leaves_room(query, query.to))
    return {.status = RouteStatus::GoalBlocked};
  RouteQuery open = query;
  open.closed = nullptr;
  Way way = along_curves(map, open);
  if (is_in_doubt(query, way)) way = along_curves(map, query);
  if (query.smooth) round_corners(map, query.radius, way);
  if (way.points.size() == 1) way.points.push_back(query.to);
  return way;
}

/// The search of each kind.
constexpr std::array<Way (*)(const FloorMap&, const RouteQuery&), route_kinds.size()> searches{
    find_shortest, find_along<medial_axis_way>, find_along<offset_way>};

Way search_of_kind(const FloorMap& map, const RouteQuery& query) {
  return searches[static_cast<std::size_t>(query.kind)](map, query);
}

/// The way of a point. Where an end touches a wall from behind, exact predicates see that wall and
/// distances do not; then the way runs between places that both call inside.
Way search_of_point(const FloorMap& map, const RouteQuery& asked) {
  Way way = search_of_kind(map, asked);
  if (way.status != RouteStatus::NoRoute) return way;
  RouteQuery query = asked;
  query.from = map.walls().brought_inside(asked.from);
  query.to = map.walls().brought_inside(asked.to);
  if (query.from == asked.from && query.to == asked.to) return way;
  way = search_of_kind(map, query);
  if (way.status != RouteStatus::Ok) return way;
  way.points.front() = asked.from;
  way.points.back() = asked.to;
  return way;
}

}  // namespace

std::shared_ptr<const FloorMap> make_floor_map(const Floor& floor) {
  return std::make_shared<const FloorMap>(floor);
}

Way route(const FloorMap& map, const RouteQuery& asked) {
  RouteQuery query = asked;
  if (!(query.radius >= smallest_radius)) query.radius = 0;
  std::shared_ptr<const ClosedDoors> just_now;  // kept until the answer is found
  if (query.closed == nullptr) {
    just_now = map.closed();
    query.closed = just_now.get();
  }
  return query.radius == 0 ? search_of_point(map, query) : search_of_kind(map, query);
}

Way tour(const FloorMap& map, const RouteQuery& asked, std::span<const Vec2> stops) {
  RouteQuery query = asked;
  if (!(query.radius >= smallest_radius)) query.radius = 0;
  if (stops.empty()) return {.status = RouteStatus::StartBlocked};
  for (std::size_t i = 0; i < stops.size(); ++i)
    if (!map.has_room(stops[i], query.radius) || !leaves_room(query, stops[i]))
      return {.status = i == 0 ? RouteStatus::StartBlocked : RouteStatus::GoalBlocked};
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

}  // namespace docent::path
