#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "runtime/path/building/building_way.h"
#include "runtime/path/building/stop_ways.h"

namespace docent::path {

/// For which queries costs between stops are the same.
struct CostKey {
  RouteQuery kind;  ///< Its ends do not count.
  Metric metric = Metric::Time;
  Permissions permissions;
  std::shared_ptr<const BuildingClosure> closed{};  ///< Null: nothing more.

  friend bool operator==(const CostKey& a, const CostKey& b) noexcept;
};

/// The cheapest ways from one stop, by which one leaves its floor, to all others, at which one
/// comes out. Of each: what it costs (infinity where there is none), the stop from which the last
/// ride begins, and the one at which the ride before that ended, if there was any.
struct CostsFromStop {
  std::vector<double> cost;
  std::vector<std::uint32_t> ride_from, came_from;
};

/// The cheapest ways between all stops of a building, found from each stop when it is first asked
/// for (Dijkstra 1959). Any thread may ask.
class StopCosts {
 public:
  /// Borrows all but the key. `ways`: of the key's kind.
  StopCosts(CostKey key, std::shared_ptr<const StopWays> ways, const BuildingStops& stops,
            std::span<const std::vector<Ride>> rides, std::span<const Connection> connections);

  const CostKey& key() const noexcept { return key_; }
  const std::shared_ptr<const StopWays>& ways() const noexcept { return ways_; }
  /// May a ride by that connection be taken?
  bool is_permitted(std::uint32_t connection) const noexcept;
  const CostsFromStop& from(std::uint32_t stop) const;

  /// What a way along a floor costs, and what a ride does.
  double of_metres(double metres) const noexcept {
    return key_.metric == Metric::Time ? metres / strolling_pace : metres;
  }
  double of(const Ride& ride) const noexcept {
    return key_.metric == Metric::Time ? ride.seconds : ride.length;
  }

 private:
  CostsFromStop search(std::uint32_t stop) const;

  CostKey key_;
  std::shared_ptr<const StopWays> ways_;
  const BuildingStops& stops_;
  std::span<const std::vector<Ride>> rides_;
  std::span<const Connection> connections_;
  struct Row {
    std::once_flag once;
    CostsFromStop costs;
  };
  mutable std::vector<Row> rows_;
};

}  // namespace docent::path
