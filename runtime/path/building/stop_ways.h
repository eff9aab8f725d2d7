#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/model/connection.h"
#include "runtime/path/building/building_way.h"
#include "runtime/path/floor_map.h"

namespace docent::path {

/// A stop of some connection of a building.
struct BuildingStop {
  std::uint32_t connection = 0, stop = 0;
  std::uint32_t floor = 0;
  Vec2 position{};
};

/// All stops of a building, those of a floor beside each other.
struct BuildingStops {
  std::vector<BuildingStop> stop;
  std::vector<std::uint32_t> first_of_floor;  ///< One a floor, and one more.

  std::uint32_t first(std::uint32_t floor) const noexcept { return first_of_floor[floor]; }
  std::uint32_t end(std::uint32_t floor) const noexcept { return first_of_floor[floor + 1]; }
};
BuildingStops stops_of(std::span<const Connection> connections, std::size_t floors);

/// A journey by a connection, from one stop of it to another.
struct Ride {
  std::uint32_t to = 0;  ///< Index into BuildingStops.
  double seconds = 0, length = 0;
};
/// The rides from each stop, whatever may be taken. `ordinals`: of the floors.
std::vector<std::vector<Ride>> rides_of(std::span<const Connection> connections,
                                        const BuildingStops& stops,
                                        std::span<const std::int32_t> ordinals);

/// How far it is along the floor from each stop to the others of its floor, by one kind of way of
/// one radius: metres, infinity where there is no way.
class StopWays {
 public:
  StopWays(const BuildingStops& stops, std::span<const std::shared_ptr<const FloorMap>> maps,
           const RouteQuery& kind, const BuildingClosure* closed);

  /// Infinity too where they are on two floors.
  double length(std::uint32_t from, std::uint32_t to) const noexcept {
    return length_[from * count_ + to];
  }

 private:
  std::size_t count_;
  std::vector<double> length_;  ///< By `from`, then by `to`.
};

}  // namespace docent::path
