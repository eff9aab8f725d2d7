#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "runtime/model/closures.h"
#include "runtime/model/museum.h"
#include "runtime/path/building/building_way.h"
#include "runtime/path/building/stop_costs.h"
#include "runtime/path/building/stop_ways.h"
#include "runtime/path/floor_map.h"

namespace docent::path {

/// The floors of a building and what joins them, made ready for queries.
///
/// A way is exact: of all sequences of connections, and all ways along floors of the kind asked
/// for, none costs less. The floors' parts between stops do not depend on the query and are found
/// once for each kind and radius. A query bounds what its two ends add by the straight line, and
/// finds true ways only to those stops that may still matter.
///
/// Any thread may ask. Borrows the museum, which must outlive it.
class BuildingMap {
 public:
  /// `maps`: one for each of the museum's floors.
  BuildingMap(const Museum& museum, std::vector<std::shared_ptr<const FloorMap>> maps);

  BuildingWay route(const BuildingQuery& query) const;

  /// What is closed, made ready for queries of this building.
  std::shared_ptr<const BuildingClosure> closure(const Closures& closures) const;
  /// From now on that is closed, on its floors' maps too; null: nothing is. Any thread.
  void close(std::shared_ptr<const BuildingClosure> closure) noexcept;

  const FloorMap& floor(std::uint32_t index) const noexcept { return *maps_[index]; }
  const BuildingStops& stops() const noexcept { return stops_; }
  /// The costs between stops that queries of that kind go by.
  std::shared_ptr<const StopCosts> stop_costs(const BuildingQuery& kind, Metric metric) const {
    return costs_for(kind, metric);
  }

 private:
  class Search;

  BuildingWay permitted_route(const BuildingQuery& query) const;
  bool has_room(const BuildingQuery& query, std::uint32_t floor, Vec2 point) const;
  /// The answer Closed: what is in the way of a way through all that is closed.
  BuildingWay closed_on(const BuildingWay& open, const BuildingQuery& query) const;
  /// The last few are kept.
  std::shared_ptr<const StopCosts> costs_for(const BuildingQuery& query, Metric metric) const;

  const Museum& museum_;
  std::vector<std::shared_ptr<const FloorMap>> maps_;
  BuildingStops stops_;
  std::vector<std::vector<Ride>> rides_;  ///< Per stop.
  std::atomic<std::shared_ptr<const BuildingClosure>> closed_;
  mutable std::mutex mutex_;                                     ///< Of what follows.
  mutable std::vector<std::shared_ptr<const StopCosts>> costs_;  ///< The last used first.
};

}  // namespace docent::path
