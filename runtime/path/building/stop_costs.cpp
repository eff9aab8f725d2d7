#include "runtime/path/building/stop_costs.h"

#include <queue>
#include <utility>

#include "runtime/model/none.h"

namespace docent::path {

bool operator==(const CostKey& a, const CostKey& b) noexcept {
  return a.kind.kind == b.kind.kind && a.kind.radius == b.kind.radius &&
         a.kind.offset == b.kind.offset && a.kind.hand == b.kind.hand &&
         a.kind.widest == b.kind.widest && a.kind.smooth == b.kind.smooth && a.metric == b.metric &&
         a.permissions == b.permissions && a.closed == b.closed;
}

StopCosts::StopCosts(CostKey key, std::shared_ptr<const StopWays> ways, const BuildingStops& stops,
                     std::span<const std::vector<Ride>> rides,
                     std::span<const Connection> connections)
    : key_(std::move(key)),
      ways_(std::move(ways)),
      stops_(stops),
      rides_(rides),
      connections_(connections),
      rows_(stops.stop.size()) {}

bool StopCosts::is_permitted(std::uint32_t connection) const noexcept {
  const Connection& asked = connections_[connection];
  const Permissions& permissions = key_.permissions;
  const bool is_closed = asked.closed || (key_.closed && key_.closed->connection[connection] != 0);
  return (permissions.closed_too || !is_closed) && (!permissions.step_free || asked.step_free) &&
         !(permissions.no_escalators && asked.kind == ConnectionKind::Escalator);
}

const CostsFromStop& StopCosts::from(std::uint32_t stop) const {
  Row& row = rows_[stop];
  std::call_once(row.once, [&] { row.costs = search(stop); });
  return row.costs;
}

/// A stop is come to on foot, and then left by a ride, or by a ride, and then left on foot.
CostsFromStop StopCosts::search(std::uint32_t stop) const {
  const std::size_t count = stops_.stop.size();
  CostsFromStop found{.cost = std::vector(count, infinity),
                      .ride_from = std::vector(count, none),
                      .came_from = std::vector(count, none)};
  std::vector<double> on_foot(count, infinity);
  std::vector<std::uint32_t> walked_from(count, none);
  using Entry = std::pair<double, std::uint32_t>;  // of stops come to by a ride
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto ride_on = [&](std::uint32_t from) {
    if (!is_permitted(stops_.stop[from].connection)) return;
    for (const Ride& ride : rides_[from]) {
      const double cost = on_foot[from] + of(ride);
      if (cost >= found.cost[ride.to]) continue;
      found.cost[ride.to] = cost;
      found.ride_from[ride.to] = from;
      found.came_from[ride.to] = walked_from[from];
      open.emplace(cost, ride.to);
    }
  };
  on_foot[stop] = 0;
  ride_on(stop);
  while (!open.empty()) {
    const auto [cost, at] = open.top();
    open.pop();
    if (cost > found.cost[at]) continue;
    const std::uint32_t floor = stops_.stop[at].floor;
    for (std::uint32_t next = stops_.first(floor); next < stops_.end(floor); ++next) {
      const double walked = cost + of_metres(ways_->length(at, next));
      if (walked >= on_foot[next]) continue;
      on_foot[next] = walked;
      walked_from[next] = at;
      ride_on(next);
    }
  }
  return found;
}

}  // namespace docent::path
