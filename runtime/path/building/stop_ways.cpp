#include "runtime/path/building/stop_ways.h"

#include <algorithm>
#include <cmath>

#include "runtime/model/none.h"
#include "runtime/path/route.h"

namespace docent::path {
namespace {

bool leads(const Connection& connection, bool up) noexcept {
  return connection.direction == ConnectionDirection::Both ||
         (connection.direction == ConnectionDirection::Up) == up;
}

}  // namespace

BuildingStops stops_of(std::span<const Connection> connections, std::size_t floors) {
  BuildingStops stops;
  for (std::uint32_t c = 0; c < connections.size(); ++c)
    for (std::uint32_t s = 0; s < connections[c].stops.size(); ++s) {
      const ConnectionStop& stop = connections[c].stops[s];
      stops.stop.push_back({c, s, stop.floor, stop.placement.position});
    }
  std::ranges::stable_sort(stops.stop, {}, &BuildingStop::floor);
  for (std::uint32_t floor = 0; floor <= floors; ++floor)
    stops.first_of_floor.push_back(static_cast<std::uint32_t>(
        std::ranges::lower_bound(stops.stop, floor, {}, &BuildingStop::floor) -
        stops.stop.begin()));
  return stops;
}

std::vector<std::vector<Ride>> rides_of(std::span<const Connection> connections,
                                        const BuildingStops& stops,
                                        std::span<const std::int32_t> ordinals) {
  std::vector<std::vector<Ride>> rides(stops.stop.size());
  for (std::uint32_t from = 0; from < stops.stop.size(); ++from)
    for (std::uint32_t to = 0; to < stops.stop.size(); ++to) {
      const BuildingStop &a = stops.stop[from], &b = stops.stop[to];
      const Connection& connection = connections[a.connection];
      if (a.connection != b.connection || from == to || !leads(connection, b.stop > a.stop))
        continue;
      const double count = std::max(1, std::abs(ordinals[b.floor] - ordinals[a.floor]));
      rides[from].push_back(
          {.to = to,
           .seconds = connection.wait_seconds + count * connection.seconds_per_floor,
           .length = count * connection.metres_per_floor});
    }
  return rides;
}

StopWays::StopWays(const BuildingStops& stops,
                   std::span<const std::shared_ptr<const FloorMap>> maps, const RouteQuery& kind,
                   const BuildingClosure* closed)
    : count_(stops.stop.size()), length_(count_ * count_, infinity) {
  RouteQuery query = kind;
  query.tell_clearance = false;
  for (std::uint32_t from = 0; from < count_; ++from) {
    const std::uint32_t floor = stops.stop[from].floor;
    query.closed = doors_closed_on(closed, floor);
    for (std::uint32_t to = stops.first(floor); to < stops.end(floor); ++to) {
      query.from = stops.stop[from].position;
      query.to = stops.stop[to].position;
      const Way way = route(*maps[floor], query);
      if (way.status == RouteStatus::Ok) length_[from * count_ + to] = way.length;
    }
  }
}

}  // namespace docent::path
