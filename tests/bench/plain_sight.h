#pragma once

#include <cstdint>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"

namespace docent::bench {

/// Do two points see each other over the closed floor (touching walls allowed)? Decided with exact
/// predicates against the walls in the cells of a uniform grid that the segment passes; it shares
/// no code with the product's own answer. Borrows the plan.
class PlainSight {
 public:
  explicit PlainSight(const FloorPlan& plan);

  /// Both points on the closed floor.
  [[nodiscard]] bool sees(Vec2 from, Vec2 to) const;

  /// The vertex before one in its ring.
  [[nodiscard]] std::uint32_t previous(std::uint32_t vertex) const { return previous_[vertex]; }

 private:
  [[nodiscard]] int column_of(double x) const noexcept;
  [[nodiscard]] int row_of(double y) const noexcept;
  [[nodiscard]] std::size_t cell_of(int column, int row) const noexcept;
  template <class Visit>
  void visit_cells(Vec2 from, Vec2 to, Visit visit) const;
  [[nodiscard]] bool is_blocked_by(std::uint32_t wall, Vec2 from, Vec2 to) const;
  [[nodiscard]] bool leaves_into_floor(std::uint32_t vertex, Vec2 towards) const;

  const FloorPlan& plan_;
  std::vector<std::uint32_t> previous_;
  Vec2 low_{};
  double cells_per_metre_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::uint32_t>> cell_walls_;
};

}  // namespace docent::bench
