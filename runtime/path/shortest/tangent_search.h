#pragma once

#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/sight_map.h"
#include "runtime/path/index/wall_grid.h"
#include "runtime/path/shortest/landmarks.h"
#include "runtime/path/shortest/reflex_corner.h"
#include "runtime/path/way.h"

namespace docent::path {

/// What a search for the shortest way of any radius needs: which corners see each other, and the
/// walls. Immutable, so any thread may ask. Borrows plan, sight and walls (a grid of radius 0).
class TangentSearchMap {
 public:
  TangentSearchMap(const FloorPlan& plan, const SightMap& sight, const WallGrid& walls);

  const FloorPlan& plan() const noexcept { return plan_; }
  const WallGrid& walls() const noexcept { return walls_; }
  const Landmarks& landmarks() const noexcept { return landmarks_; }
  std::uint32_t corners() const noexcept { return static_cast<std::uint32_t>(corner_.size()); }
  const ReflexCorner& corner(std::uint32_t i) const noexcept { return corner_[i]; }
  /// Unit normal of the wall that ends at the corner.
  Vec2 corner_end(std::uint32_t i) const noexcept { return end_[i]; }
  std::uint32_t wall_before(std::uint32_t i) const noexcept { return before_[i]; }
  /// The corners that corner i sees.
  std::span<const std::uint32_t> seen_from(std::uint32_t i) const noexcept;
  /// The corners that a point may see.
  std::span<const std::uint32_t> seen_from(Vec2 point) const noexcept;

 private:
  const FloorPlan& plan_;
  const SightMap& sight_;
  const WallGrid& walls_;
  Landmarks landmarks_;
  std::vector<ReflexCorner> corner_;  ///< One per corner of the sight map.
  std::vector<Vec2> end_;
  std::vector<std::uint32_t> before_;  ///< One per corner: the wall that ends there.
};

/// The same as shortest_way, for a disc of any radius and with nothing precomputed for it: A* over
/// tangents that are found when the way reaches a corner, and tested against the walls when their
/// turn comes.
Way search_tangents(const TangentSearchMap& map, double radius, Vec2 from, Vec2 to);

}  // namespace docent::path
