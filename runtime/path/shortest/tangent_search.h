#pragma once

#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/sight_map.h"
#include "runtime/path/closure/closed_doors.h"
#include "runtime/path/index/wall_grid.h"
#include "runtime/path/shortest/landmarks.h"
#include "runtime/path/shortest/reflex_corner.h"
#include "runtime/path/way.h"

namespace docent::path {

/// What a search for the shortest way of any radius needs: which corners see each other, and the
/// walls. Immutable, so any thread may ask. Borrows plan, sight and walls (a grid of radius 0).
class TangentSearchMap {
 public:
  /// Discs are seldom wider. Metres.
  static constexpr double usual_radius = 0.5;

  TangentSearchMap(const FloorPlan& plan, const SightMap& sight, const WallGrid& walls);

  const FloorPlan& plan() const noexcept { return plan_; }
  const WallGrid& walls() const noexcept { return walls_; }
  const Landmarks& landmarks() const noexcept { return landmarks_; }
  std::uint32_t corners() const noexcept { return static_cast<std::uint32_t>(corner_.size()); }
  const ReflexCorner& corner(std::uint32_t i) const noexcept { return corner_[i].corner; }
  /// Is a direction from the corner between the normals of its walls?
  bool touches(std::uint32_t i, Vec2 direction) const noexcept {
    return cross(corner_[i].corner.begin, direction) >= -same_angle &&
           cross(direction, corner_[i].end) >= -same_angle;
  }
  std::uint32_t wall_before(std::uint32_t i) const noexcept { return before_[i]; }
  /// Has a disc of up to the usual radius room all along the corner's arc?
  bool has_usual_room(std::uint32_t i) const noexcept { return has_usual_room_[i] != 0; }
  /// The corners that corner i sees.
  std::span<const std::uint32_t> seen_from(std::uint32_t i) const noexcept;
  /// The sides at which a tangent of a disc of up to the usual radius may arrive that leaves a
  /// side, and perhaps some more. Sides 2 i and 2 i + 1 are corner i's, walked counter-clockwise
  /// and clockwise.
  std::span<const std::uint32_t> usual_sides_after(std::uint32_t side) const noexcept {
    return std::span(usual_side_)
        .subspan(usual_first_[side], usual_first_[side + 1] - usual_first_[side]);
  }
  /// The corners that a point may see.
  std::span<const std::uint32_t> seen_from(Vec2 point) const noexcept;

 private:
  bool may_lead(std::uint32_t side, std::uint32_t to_side) const noexcept;
  void list_usual_sides();

  const FloorPlan& plan_;
  const SightMap& sight_;
  const WallGrid& walls_;
  Landmarks landmarks_;
  /// In one cache line.
  struct alignas(64) Corner {
    ReflexCorner corner;
    Vec2 end;  ///< Unit normal of the wall that ends at the corner.
  };
  std::vector<Corner> corner_;         ///< One per corner of the sight map.
  std::vector<std::uint32_t> before_;  ///< One per corner: the wall that ends there.
  std::vector<std::uint32_t> usual_first_{0}, usual_side_;
  std::vector<std::uint8_t> has_usual_room_;  ///< One per corner.
};

/// The same as shortest_way, for a disc of any radius and with nothing precomputed for it: A* over
/// tangents that are found when the way reaches a corner, and tested against the walls when their
/// turn comes. `closed`: doors that nobody passes; null for none.
Way search_tangents(const TangentSearchMap& map, double radius, Vec2 from, Vec2 to,
                    const ClosedDoors* closed = nullptr);

}  // namespace docent::path
