#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include "runtime/model/geometry/floor.h"
#include "runtime/path/shortest/shortest_way_map.h"

namespace docent::path {

/// The shortest-way maps of a floor: those of the radius classes that the database holds, and those
/// of other radii, which a thread of its own makes when they are first asked for. Thread-safe.
/// Borrows what it is made from.
class RadiusMaps {
 public:
  RadiusMaps(const Floor& floor, const TangentSearchMap& search);

  /// The map for a radius; null while it is not made yet (ask again later), and where the radius
  /// has no labels. The thread makes the radius that was asked for last.
  std::shared_ptr<const ShortestWayMap> find(double radius) const;

 private:
  static constexpr std::size_t kept_radii = 8;
  struct Owned {
    Owned(const Floor& floor, const TangentSearchMap& search, double radius,
          const std::stop_token& stop);
    TangentGraph graph;
    HubLabels labels;
    ShortestWayMap map;
  };
  void make_wanted(const std::stop_token& stop) const;

  const Floor& floor_;
  const TangentSearchMap& search_;
  /// Null where a radius has no labels.
  struct Known {
    double radius;
    std::shared_ptr<const ShortestWayMap> map;
  };
  std::vector<std::unique_ptr<const ShortestWayMap>> of_classes_;
  std::vector<Known> precomputed_;   ///< Own nothing, so that nobody counts who uses them.
  mutable std::mutex mutex_;         ///< Of the next two.
  mutable std::vector<Known> made_;  ///< Oldest first.
  mutable std::optional<double> wanted_;
  mutable std::condition_variable_any asked_;
  mutable std::jthread thread_;  ///< Last: it uses all of the above. Begins with the first asking.
};

}  // namespace docent::path
