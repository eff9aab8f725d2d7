#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/path/medial_axis/road_graph.h"
#include "runtime/path/shortest/free_arcs.h"
#include "runtime/path/shortest/landmarks.h"

namespace docent::path {

/// The doors of a floor that are closed just now, as walls that the plan does not have.
///
/// A leaf reaches from wall to wall, so it has no free end on which a way could bend: ways of a
/// floor with leaves are made of the pieces that ways of the floor without them are made of. What
/// is precomputed for the floor stays true, but for the pieces that a leaf is in the way of.
///
/// Immutable, so any thread may ask. Borrows the roads.
class ClosedDoors {
 public:
  /// All doors are open.
  ClosedDoors() = default;
  /// `doors`: indices of plan.doors. Those that are walls of the plan already, and those that do
  /// not cross the floor, do not count. `slack`: of the floor's walls (wall_grid.h).
  ClosedDoors(const FloorPlan& plan, const SightMap& sight, double slack, const RoadGraph& roads,
              std::span<const std::uint32_t> doors);

  bool empty() const noexcept { return leaf_.empty(); }

  /// Metres from the nearest leaf.
  double distance(Vec2 point) const noexcept;
  double distance(Vec2 p, Vec2 q) const noexcept;

  /// May the centre of a disc be here, as far as leaves go?
  bool has_room(Vec2 point, double radius) const noexcept;
  /// Is a leaf in the way of a disc that goes straight from p to q?
  bool blocks(Vec2 p, Vec2 q, double radius) const noexcept;
  /// May a leaf be in the way of a flattened way? Where not, none is.
  bool may_block(std::span<const Vec2> points, double radius) const noexcept;
  /// Does a line go through a leaf?
  bool crosses(std::span<const Vec2> points) const noexcept;
  /// The doors that a line goes through, ascending.
  std::vector<std::uint32_t> crossed(std::span<const Vec2> points) const;

  /// Takes out of a corner's free arcs what a leaf is too near to.
  void cut_arcs(const ReflexCorner& corner, double radius, std::vector<ArcInterval>& free) const;

  /// Those of the floor as it is closed; null where all doors are open.
  const Landmarks* landmarks() const noexcept { return landmarks_ ? &*landmarks_ : nullptr; }

  /// Where leaves cut a road: metres from its begin, ascending.
  std::span<const double> cuts_of(std::uint32_t road) const noexcept {
    if (cut_.empty()) return {};
    return std::span(cut_).subspan(cut_first_[road], cut_first_[road + 1] - cut_first_[road]);
  }

 private:
  struct Leaf {
    Vec2 a, b;          ///< On the walls.
    Vec2 far_a, far_b;  ///< A little inside them, so that nothing slips through.
    std::uint32_t door;
  };
  void add(const FloorPlan& plan, std::uint32_t index);
  void measure_landmarks(const FloorPlan& plan, const SightMap& sight);
  void cut_roads(const RoadGraph& roads);

  std::vector<Leaf> leaf_;
  double slack_ = 0;
  std::optional<Landmarks> landmarks_;
  std::vector<std::uint32_t> cut_first_;  ///< One a road, and one more.
  std::vector<double> cut_;
};

}  // namespace docent::path
