#include "runtime/path/building/building_map.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "runtime/model/none.h"
#include "runtime/path/route.h"

namespace docent::path {
namespace {

constexpr std::size_t most_costs = 16;

std::vector<std::int32_t> ordinals_of(const Museum& museum) {
  std::vector<std::int32_t> ordinals;
  for (const Floor& floor : museum.floors) ordinals.push_back(floor.plan.ordinal);
  return ordinals;
}

}  // namespace

/// One query. The two ends' ways to stops are found in the order in which they may matter: those of
/// the pair whose bound is least, until a pair's ways are both found.
class BuildingMap::Search {
 public:
  Search(const BuildingMap& building, const BuildingQuery& query, const StopCosts& costs)
      : building_(building), query_(query), costs_(costs) {}

  BuildingWay run() {
    add_ends(query_.from_floor, leaving_, [&](RouteQuery& way, Vec2 stop) { way.to = stop; });
    add_ends(query_.to_floor, arriving_, [&](RouteQuery& way, Vec2 stop) { way.from = stop; });
    if (query_.from_floor == query_.to_floor)
      direct_ = EndWay{.query = query_.way, .cost = bound(query_.way)};
    while (true) {
      const Choice best = cheapest();
      if (best.cost == infinity) return {};
      if (best.leaving == none) {
        if (direct_->way) return along_the_floor();
        find(*direct_, query_.from_floor);
        continue;
      }
      EndWay &out = leaving_[best.leaving], &in = arriving_[best.arriving];
      if (out.way && in.way) return by_connections(out, in);
      if (!out.way)
        find(out, query_.from_floor);
      else
        find(in, query_.to_floor);
    }
  }

 private:
  /// The way along a floor between an end of the whole way and a stop. Until it is found, all that
  /// is known of it is that no way is shorter than the straight line.
  struct EndWay {
    std::uint32_t stop = none;
    RouteQuery query;
    double cost = 0;  ///< At least.
    std::optional<Way> way{};
  };
  /// By connections, from one of `leaving_` to one of `arriving_`; or without, where they are none.
  struct Choice {
    double cost = infinity;
    std::uint32_t leaving = none, arriving = none;
  };

  double bound(const RouteQuery& way) const noexcept {
    return costs_.of_metres(glm::distance(way.from, way.to));
  }

  void add_ends(std::uint32_t floor, std::vector<EndWay>& ends, auto set_end) {
    const BuildingStops& stops = building_.stops_;
    for (std::uint32_t stop = stops.first(floor); stop < stops.end(floor); ++stop) {
      if (!costs_.is_permitted(stops.stop[stop].connection)) continue;
      EndWay end{.stop = stop, .query = query_.way};
      set_end(end.query, stops.stop[stop].position);
      end.cost = bound(end.query);
      ends.push_back(std::move(end));
    }
  }

  Choice cheapest() const {
    Choice best;
    if (direct_) best.cost = direct_->cost;
    for (std::uint32_t out = 0; out < leaving_.size(); ++out) {
      if (leaving_[out].cost >= best.cost) continue;
      const CostsFromStop& rides = costs_.from(leaving_[out].stop);
      for (std::uint32_t in = 0; in < arriving_.size(); ++in) {
        const double cost =
            leaving_[out].cost + rides.cost[arriving_[in].stop] + arriving_[in].cost;
        if (cost < best.cost) best = {cost, out, in};
      }
    }
    return best;
  }

  void find(EndWay& end, std::uint32_t floor) const {
    end.way = path::route(*building_.maps_[floor], on(floor, end.query));
    end.cost = end.way->status == RouteStatus::Ok ? costs_.of_metres(end.way->length) : infinity;
  }

  /// The same question, with the doors that are closed on a floor.
  RouteQuery on(std::uint32_t floor, RouteQuery way) const noexcept {
    way.closed = doors_closed_on(query_.closed.get(), floor);
    return way;
  }

  static void add_floor(BuildingWay& whole, std::uint32_t floor, Way way) {
    whole.clearance_min =
        whole.legs.empty() ? way.clearance_min : std::min(whole.clearance_min, way.clearance_min);
    whole.length += way.length;
    whole.seconds += way.length / strolling_pace;
    whole.legs.push_back({.floor = floor,
                          .to_floor = floor,
                          .length = way.length,
                          .seconds = way.length / strolling_pace,
                          .points = std::move(way.points)});
  }

  void add_ride(BuildingWay& whole, std::uint32_t from, std::uint32_t to) const {
    const BuildingStops& stops = building_.stops_;
    const auto ride = std::ranges::find(building_.rides_[from], to, &Ride::to);
    whole.length += ride->length;
    whole.seconds += ride->seconds;
    whole.legs.push_back({.floor = stops.stop[from].floor,
                          .connection = stops.stop[from].connection,
                          .to_floor = stops.stop[to].floor,
                          .length = ride->length,
                          .seconds = ride->seconds});
  }

  BuildingWay along_the_floor() {
    BuildingWay whole;
    whole.status = BuildingStatus::Ok;
    add_floor(whole, query_.from_floor, std::move(*direct_->way));
    return whole;
  }

  BuildingWay by_connections(EndWay& out, EndWay& in) {
    struct Between {
      std::uint32_t from, to;
    };
    std::vector<Between> rides;  // from the last to the first
    const CostsFromStop& costs = costs_.from(out.stop);
    for (std::uint32_t at = in.stop; at != none; at = costs.came_from[at])
      rides.push_back({costs.ride_from[at], at});
    std::ranges::reverse(rides);

    BuildingWay whole;
    whole.status = BuildingStatus::Ok;
    add_floor(whole, query_.from_floor, std::move(*out.way));
    for (std::size_t i = 0; i < rides.size(); ++i) {
      if (i > 0) add_walk(whole, rides[i - 1].to, rides[i].from);
      add_ride(whole, rides[i].from, rides[i].to);
    }
    add_floor(whole, query_.to_floor, std::move(*in.way));
    return whole;
  }

  void add_walk(BuildingWay& whole, std::uint32_t from, std::uint32_t to) const {
    const BuildingStops& stops = building_.stops_;
    RouteQuery query = query_.way;
    query.from = stops.stop[from].position;
    query.to = stops.stop[to].position;
    const std::uint32_t floor = stops.stop[from].floor;
    add_floor(whole, floor, path::route(*building_.maps_[floor], on(floor, query)));
  }

  const BuildingMap& building_;
  const BuildingQuery& query_;
  const StopCosts& costs_;
  std::vector<EndWay> leaving_, arriving_;
  std::optional<EndWay> direct_;
};

BuildingMap::BuildingMap(const Museum& museum, std::vector<std::shared_ptr<const FloorMap>> maps)
    : museum_(museum),
      maps_(std::move(maps)),
      stops_(stops_of(museum.connections, museum.floors.size())),
      rides_(rides_of(museum.connections, stops_, ordinals_of(museum))) {}

std::shared_ptr<const StopCosts> BuildingMap::costs_for(const BuildingQuery& query,
                                                        Metric metric) const {
  CostKey key{.kind = query.way,
              .metric = metric,
              .permissions = query.permissions,
              .closed = query.closed};
  const std::lock_guard lock(mutex_);
  const auto known = std::ranges::find(costs_, key, [](const auto& c) { return c->key(); });
  if (known != costs_.end()) {
    std::rotate(costs_.begin(), known, known + 1);
    return costs_.front();
  }
  CostKey same_ways = key;
  std::shared_ptr<const StopWays> ways;
  for (const auto& costs : costs_) {
    same_ways.metric = costs->key().metric;
    same_ways.permissions = costs->key().permissions;
    if (same_ways == costs->key()) ways = costs->ways();
  }
  if (!ways) ways = std::make_shared<StopWays>(stops_, maps_, query.way, query.closed.get());
  if (costs_.size() == most_costs) costs_.pop_back();
  costs_.insert(costs_.begin(), std::make_shared<StopCosts>(key, std::move(ways), stops_, rides_,
                                                            museum_.connections));
  return costs_.front();
}

std::shared_ptr<const BuildingClosure> BuildingMap::closure(const Closures& closures) const {
  auto closure = std::make_shared<BuildingClosure>();
  for (std::uint32_t floor = 0; floor < maps_.size(); ++floor) {
    auto& doors = closure->floors.emplace_back();
    if (floor >= closures.doors.size() || closures.doors[floor].empty()) continue;
    const FloorMap& map = *maps_[floor];
    doors = std::make_shared<const ClosedDoors>(map.plan(), map.floor().sight, map.walls().slack(),
                                                map.medial_axis().roads(), closures.doors[floor]);
  }
  closure->connection.assign(museum_.connections.size(), 0);
  for (const std::uint32_t connection : closures.connections) closure->connection[connection] = 1;
  return closure;
}

void BuildingMap::close(std::shared_ptr<const BuildingClosure> closure) noexcept {
  for (std::uint32_t floor = 0; floor < maps_.size(); ++floor)
    maps_[floor]->close(closure ? closure->floors[floor] : nullptr);
  closed_.store(std::move(closure));
}

BuildingWay BuildingMap::permitted_route(const BuildingQuery& asked) const {
  BuildingQuery query = asked;
  if (query.permissions.closed_too) query.closed.reset();
  const Metric metric =
      query.metric.value_or(query.from_floor == query.to_floor ? Metric::Length : Metric::Time);
  return Search(*this, query, *costs_for(query, metric)).run();
}

bool BuildingMap::has_room(const BuildingQuery& query, std::uint32_t floor, Vec2 point) const {
  const ClosedDoors* closed =
      query.closed && !query.permissions.closed_too ? query.closed->on(floor) : nullptr;
  return maps_[floor]->has_room(point, query.way.radius) &&
         (closed == nullptr || closed->has_room(point, query.way.radius));
}

BuildingWay BuildingMap::closed_on(const BuildingWay& open, const BuildingQuery& query) const {
  BuildingWay answer{.status = BuildingStatus::Closed};
  for (const Leg& leg : open.legs) {
    if (!leg.is_along_floor()) {
      if (museum_.connections[leg.connection].closed ||
          (query.closed && query.closed->connection[leg.connection] != 0))
        answer.closed.push_back(leg.connection);
    } else if (query.closed && query.closed->on(leg.floor) != nullptr) {
      for (const std::uint32_t door : query.closed->on(leg.floor)->crossed(leg.points))
        answer.closed_doors.push_back({leg.floor, door});
    }
  }
  return answer;
}

BuildingWay BuildingMap::route(const BuildingQuery& asked) const {
  BuildingQuery query = asked;
  if (!query.closed) query.closed = closed_.load();
  const RouteQuery& way = query.way;
  const auto blocked = [&](BuildingStatus status) { return BuildingWay{.status = status}; };
  if (!has_room(query, query.from_floor, way.from)) return blocked(BuildingStatus::StartBlocked);
  if (!has_room(query, query.to_floor, way.to)) return blocked(BuildingStatus::GoalBlocked);
  BuildingWay found = permitted_route(query);
  if (found.status == BuildingStatus::Ok || query.permissions.closed_too) return found;

  BuildingQuery freer = query;
  freer.permissions.closed_too = true;
  if (const BuildingWay open = permitted_route(freer); open.status == BuildingStatus::Ok)
    return closed_on(open, query);
  freer.permissions = {};
  if (query.permissions.step_free && permitted_route(freer).status == BuildingStatus::Ok)
    return blocked(BuildingStatus::NoStepFree);
  return found;
}

}  // namespace docent::path
