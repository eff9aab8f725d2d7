#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "runtime/model/geometry/floor.h"
#include "runtime/path/closure/closed_doors.h"
#include "runtime/path/index/wall_grid.h"
#include "runtime/path/medial_axis/medial_axis_map.h"
#include "runtime/path/route.h"
#include "runtime/path/shortest/radius_maps.h"

namespace docent::path {

/// Does a disc fit somewhere? `Behind`: it is a point, and touches a wall from behind (touching.h).
enum class Fit : std::uint8_t { None, Behind, Inside };

/// Everything that `route.h` asks of a floor. Any thread may ask. Its answers do not change, but
/// for what is closed just now, of which any thread may tell at any time; and the maps of radii
/// that the compiler did not precompute are made in the background and kept.
class FloorMap {
 public:
  explicit FloorMap(const Floor& floor);

  const Floor& floor() const noexcept { return floor_; }
  const FloorPlan& plan() const noexcept { return floor_.plan; }
  /// Grid of radius 0.
  const WallGrid& walls() const noexcept { return walls_; }
  const MedialAxisMap& medial_axis() const noexcept { return axis_; }

  /// Is the point on the open side of its nearest wall? A point on a wall is inside.
  bool is_inside(Vec2 point) const noexcept { return walls_.is_inside(point); }
  double clearance_at(Vec2 point) const noexcept { return walls_.nearest_wall(point).distance; }
  /// The site whose region holds the point, or is nearest to it.
  std::uint32_t site_at(Vec2 point) const noexcept;
  std::uint32_t site_of_wall(std::uint32_t wall) const noexcept { return wall_site_[wall]; }

  Fit fit_at(Vec2 point, double radius) const noexcept;
  /// May the centre of a disc be here: inside, and no nearer to a wall than fits (touching.h)?
  bool has_room(Vec2 point, double radius) const noexcept {
    return fit_at(point, radius) != Fit::None;
  }

  /// The maps of shortest ways by radius, and the search for where there is none.
  const RadiusMaps& shortest_ways() const noexcept { return shortest_ways_; }
  const TangentSearchMap& search() const noexcept { return search_; }

  /// From now on these doors are closed; null: none is. Ways that are asked for hold to it.
  void close(std::shared_ptr<const ClosedDoors> doors) const noexcept {
    const bool is_any = doors != nullptr;
    closed_.store(std::move(doors));
    is_any_closed_.store(is_any, std::memory_order_release);
  }
  std::shared_ptr<const ClosedDoors> closed() const noexcept {
    if (!is_any_closed_.load(std::memory_order_acquire)) return {};
    return closed_.load();
  }

 private:
  const Floor& floor_;
  WallGrid walls_;
  TangentSearchMap search_;
  MedialAxisMap axis_;
  std::vector<std::uint32_t> wall_site_;    ///< Per wall: its site.
  std::vector<std::uint32_t> corner_site_;  ///< Per vertex: its site where it is reflex, else of
                                            ///< the wall that begins there.
  RadiusMaps shortest_ways_;
  mutable std::atomic<std::shared_ptr<const ClosedDoors>> closed_;
  mutable std::atomic<bool> is_any_closed_{false};  ///< Asked first: `closed_` is slow to load.
};

}  // namespace docent::path
