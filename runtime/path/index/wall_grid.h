#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/path/touching.h"

namespace docent::path {

/// The walls of a floor sorted into square cells, for discs of one radius.
///
/// A cell lists every wall that is within the radius of some point of it, so a disc whose centre
/// runs along a segment can only meet walls of the cells that this segment passes. Borrows the
/// plan. Immutable after construction.
class WallGrid {
 public:
  WallGrid(const FloorPlan& plan, double radius);

  /// Can a disc of the grid's radius go from p to q in a straight line (see touching.h)? For
  /// radius 0: does the segment stay in the closed interior (decided with exact predicates)?
  /// Walls that end at p or q do not block what leaves them into the interior.
  bool segment_clear(Vec2 p, Vec2 q) const noexcept;

  /// The same for a disc of a radius above the grid's: looks at all walls about the segment.
  bool capsule_clear(Vec2 p, Vec2 q, double radius) const noexcept;

  /// Every wall that a disc of the grid's radius may touch while its centre is within `reach` of
  /// `centre`, and perhaps some more; ascending.
  std::vector<std::uint32_t> walls_about(Vec2 centre, double reach) const;

  /// The wall nearest to a point.
  struct Nearest {
    std::uint32_t wall = 0;
    double t = 0;  ///< In [0, 1], place along the wall.
    double distance =
        0;  ///< Metres. Infinite for a plan without walls or a point that is not finite.
  };
  Nearest nearest_wall(Vec2 p) const noexcept;

  /// Is the point on the open side of its nearest wall? A point on a wall is inside.
  bool is_inside(Vec2 p) const noexcept { return is_inside(p, nearest_wall(p)); }
  bool is_inside(Vec2 p, const Nearest& nearest) const noexcept;

  /// Where a point begins its ways: itself, or where it touches a wall from behind (see touching.h,
  /// or it was rounded to there), a place on that wall or just inside.
  Vec2 brought_inside(Vec2 p) const noexcept;

  /// How many cells there are, and which of them holds a point; none off the grid.
  std::size_t cells() const noexcept { return cell_first_.size() - 1; }
  std::optional<std::size_t> cell_at(Vec2 p) const noexcept;
  Vec2 centre_of(std::size_t cell) const noexcept;
  /// Does every point of the cell keep the grid's radius from every wall?
  bool is_clear(std::size_t cell) const noexcept { return walls_in(cell).empty(); }
  /// The side of a cell, metres.
  double cell_size() const noexcept { return cell_size_; }
  /// The distance of a point of the cell to the nearest wall, if that is within the grid's radius;
  /// else more than the radius.
  double distance_within(std::size_t cell, Vec2 p) const noexcept;

  /// The smallest distance from any point of the segment to a wall, metres; at most `at_most`,
  /// which is no more than the clearance of either end.
  double segment_clearance(Vec2 p, Vec2 q, double at_most) const noexcept;

  double radius() const noexcept { return radius_; }
  /// How far places on this floor may be off, in doubles: `rounding`, or more far from the origin.
  double slack() const noexcept { return slack_; }

 private:
  struct Wall {
    Vec2 a, b;
  };
  std::size_t cell_of(int x, int y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }
  std::span<const std::uint32_t> walls_in(std::size_t cell) const noexcept {
    return std::span(cell_wall_)
        .subspan(cell_first_[cell], cell_first_[cell + 1] - cell_first_[cell]);
  }
  template <class Visitor>
  void visit_cells_near_wall(const Wall& wall, Visitor visit) const;
  template <class Blocked>
  bool passes(Vec2 p, Vec2 q, Blocked blocked) const noexcept;
  void link_places();
  template <class Holds>
  bool at_place(std::uint32_t corner, Holds holds) const noexcept;
  bool crosses(Vec2 p, Vec2 q, std::uint32_t wall) const noexcept;
  bool comes_near(Vec2 p, Vec2 q, Vec2 direction, double beside, double least,
                  std::uint32_t wall) const noexcept;

  double radius_ = 0, slack_ = rounding;
  double cell_size_ = 1, cells_per_metre_ = 1;
  Vec2 origin_{};
  int columns_ = 1, rows_ = 1;
  std::vector<Wall> wall_;
  std::vector<std::uint32_t> previous_;  ///< One per wall: the wall that ends where it begins.
  std::vector<std::uint32_t>
      same_place_;  ///< One per wall: the next that begins at its place, round
                    ///< and round; itself but where obstacles share a corner.
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> cell_first_;
  std::vector<std::uint32_t> cell_wall_;
};

}  // namespace docent::path
