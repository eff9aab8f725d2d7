#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "runtime/model/geometry/floor.h"
#include "runtime/path/medial_axis_map.h"
#include "runtime/path/route.h"
#include "runtime/path/shortest_way.h"
#include "runtime/path/wall_grid.h"

namespace docent {

/// Everything that `route.h` asks of a floor. Immutable as seen from outside; inside, tangent
/// graphs of radii that the compiler did not precompute are made when first asked for and kept.
class FloorMap {
 public:
  explicit FloorMap(const Floor& floor);

  const Floor& floor() const noexcept { return floor_; }
  const FloorPlan& plan() const noexcept { return floor_.plan; }
  /// Grid of radius 0.
  const WallGrid& walls() const noexcept { return walls_; }
  const MedialAxisMap& medial_axis() const noexcept { return axis_; }

  /// The side of the nearest wall decides; a point on a wall is inside.
  bool is_inside(Vec2 point) const noexcept;
  double clearance_at(Vec2 point) const noexcept { return walls_.nearest_wall(point).distance; }
  /// The site whose region holds the point, or is nearest to it.
  std::uint32_t site_at(Vec2 point) const noexcept;
  std::uint32_t site_of_wall(std::uint32_t wall) const noexcept { return wall_site_[wall]; }

  /// May the centre of a disc be here: inside, and no nearer to a wall than the radius?
  bool has_room(Vec2 point, double radius) const noexcept;

  /// The map for a radius. Thread-safe; the first call for a radius that is not precomputed takes
  /// as long as making its tangent graph.
  std::shared_ptr<const ShortestWayMap> shortest_ways(double radius) const;

 private:
  static constexpr std::size_t kept_radii = 8;
  struct OwnedMap {
    explicit OwnedMap(const FloorPlan& plan, double radius);
    TangentGraph graph;
    ShortestWayMap map;
  };

  const Floor& floor_;
  WallGrid walls_;
  MedialAxisMap axis_;
  std::vector<std::uint32_t> previous_;     ///< Per vertex: the one before it in its ring.
  std::vector<std::uint32_t> wall_site_;    ///< Per wall: its site.
  std::vector<std::uint32_t> corner_site_;  ///< Per vertex: its site where it is reflex, else of
                                            ///< the wall that begins there.
  std::vector<std::shared_ptr<const ShortestWayMap>> precomputed_;
  mutable std::mutex mutex_;
  mutable std::vector<std::shared_ptr<const ShortestWayMap>> made_;  ///< Oldest first.
};

}  // namespace docent
