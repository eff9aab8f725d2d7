#include "runtime/plan/leg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "runtime/path/building/nearest_place.h"
#include "runtime/plan/stretch.h"

namespace docent::plan {
namespace {

path::RouteStatus route_status(path::BuildingStatus status) noexcept {
  switch (status) {
    case path::BuildingStatus::Ok:
      return path::RouteStatus::Ok;
    case path::BuildingStatus::StartBlocked:
      return path::RouteStatus::StartBlocked;
    case path::BuildingStatus::GoalBlocked:
      return path::RouteStatus::GoalBlocked;
    case path::BuildingStatus::NoRoute:
    case path::BuildingStatus::Closed:
    case path::BuildingStatus::NoStepFree:
      break;
  }
  return path::RouteStatus::NoRoute;
}

constexpr std::array room_to_spare{Museum::walking_room, 0.0, -Museum::walking_room};

path::BuildingQuery query_of(const WalkOrder& order, Vec2 from) {
  return {.way = {.kind = order.kind,
                  .from = from,
                  .to = order.goal->position,
                  .smooth = true,
                  .tell_clearance = false},
          .from_floor = order.floor,
          .to_floor = order.goal_floor.value_or(order.floor),
          .permissions = order.permissions};
}

std::uint32_t stop_on(const Connection& connection, std::uint32_t floor) noexcept {
  const auto stop = std::ranges::find(connection.stops, floor, &ConnectionStop::floor);
  return static_cast<std::uint32_t>(stop - connection.stops.begin());
}

Ride ride_of(const Museum& museum, const path::Leg& leg) noexcept {
  const Connection& connection = museum.connections[leg.connection];
  return {.connection = leg.connection,
          .from = stop_on(connection, leg.floor),
          .to = stop_on(connection, leg.to_floor),
          .wait = connection.wait_seconds,
          .seconds = std::max(0.0, leg.seconds - connection.wait_seconds),
          .metres = leg.length};
}

std::optional<interface::Hindrance> hindrance_of(const Museum& museum,
                                                 const path::BuildingWay& way) noexcept {
  if (way.status == path::BuildingStatus::NoStepFree) return interface::Hindrance::Steps;
  if (way.status != path::BuildingStatus::Closed) return {};
  if (way.closed.empty()) return interface::Hindrance::Door;
  switch (museum.connections[way.closed.front()].kind) {
    case ConnectionKind::Stairs:
      return interface::Hindrance::Stairs;
    case ConnectionKind::Escalator:
      return interface::Hindrance::Escalator;
    case ConnectionKind::Lift:
      return interface::Hindrance::Lift;
    case ConnectionKind::Ramp:
      return interface::Hindrance::Ramp;
  }
  return {};
}

/// Where there is no way without escalators, is there one with them?
bool needs_escalators(const Museum& museum, const path::BuildingMap& building,
                      const WalkOrder& order, const path::BuildingWay& way, Vec2 from) {
  if (!order.permissions.no_escalators || way.status != path::BuildingStatus::NoRoute) return false;
  WalkOrder freer = order;
  freer.permissions.no_escalators = false;
  return find_building_way(museum, building, freer, from).status == path::BuildingStatus::Ok;
}

}  // namespace

path::BuildingWay find_building_way(const Museum& museum, const path::BuildingMap& building,
                                    const WalkOrder& order, Vec2 from) {
  path::BuildingQuery query = query_of(order, from);
  path::BuildingWay way;
  for (const double more : room_to_spare) {
    query.way.radius = std::max(0.0, museum.body_radius + more);
    way = building.route(query);
    if (way.status == path::BuildingStatus::Ok) break;
  }
  return way;
}

Leg find_leg(const Museum& museum, const path::BuildingMap& building, const WalkOrder& order,
             Vec2 from) {
  const path::FloorMap& map = building.floor(order.floor);
  Leg leg{.way = {}, .end = *order.goal};
  const bool stays = order.goal_floor.value_or(order.floor) == order.floor;
  if (stays) {
    leg.way = find_way(museum, map, order.kind, from, order.goal->position);
    if (leg.way.status == path::RouteStatus::Ok || museum.connections.empty()) return leg;
  }
  const path::BuildingWay whole = find_building_way(museum, building, order, from);
  leg.way.status = route_status(whole.status);
  leg.hindrance = hindrance_of(museum, whole);
  if (needs_escalators(museum, building, order, whole, from))
    leg.hindrance = interface::Hindrance::Escalators;
  if (whole.status != path::BuildingStatus::Ok || whole.legs.size() < 2) return leg;
  const path::Leg &first = whole.legs[0], &second = whole.legs[1];
  leg.then = ride_of(museum, second);
  leg.end = museum.connections[second.connection].stops[leg.then->from].placement;
  leg.metres_after = whole.length - first.length;
  leg.seconds_after = whole.seconds - first.seconds;
  leg.way = find_way(museum, map, order.kind, from, leg.end.position);
  return leg;
}

FoundPlace find_place(const Museum& museum, const path::BuildingMap& building,
                      const WalkOrder& order, Vec2 from) {
  path::BuildingQuery query = query_of(order, from);
  path::NearestPlace nearest;
  for (const double more : room_to_spare) {
    query.way.radius = std::max(0.0, museum.body_radius + more);
    nearest = path::nearest_place(building, query, museum.places, *order.seeks);
    if (nearest.way.status == path::BuildingStatus::Ok) break;
  }
  FoundPlace found{nearest.place, route_status(nearest.way.status),
                   hindrance_of(museum, nearest.way)};
  if (order.permissions.no_escalators && nearest.way.status == path::BuildingStatus::NoRoute) {
    WalkOrder freer = order;
    freer.permissions.no_escalators = false;
    if (find_place(museum, building, freer, from).status == path::RouteStatus::Ok)
      found.hindrance = interface::Hindrance::Escalators;
  }
  return found;
}

}  // namespace docent::plan
