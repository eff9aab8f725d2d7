#include "tests/bench/plain_sight.h"
#include "runtime/model/geometry/orientation.h"

#include <algorithm>
#include <cmath>

namespace docent::bench {

PlainSight::PlainSight(const FloorPlan& plan) : plan_(plan), previous_(plan.vertex.size()) {
  Vec2 high = low_ = plan.vertex.empty() ? Vec2{} : plan.vertex.front();
  for (const Vec2 p : plan.vertex) low_ = glm::min(low_, p), high = glm::max(high, p);
  const Vec2 size = high - low_;
  cells_per_metre_ =
      std::sqrt(static_cast<double>(plan.vertex.size()) / std::max(size.x * size.y, 1e-9));
  columns_ = static_cast<int>(size.x * cells_per_metre_) + 1;
  rows_ = static_cast<int>(size.y * cells_per_metre_) + 1;
  cell_walls_.resize(cell_of(columns_ - 1, rows_ - 1) + 1);
  for (std::uint32_t wall = 0; wall < plan.next.size(); ++wall) {
    previous_[plan.next[wall]] = wall;
    visit_cells(wall_start(plan, wall), wall_end(plan, wall), [&](std::size_t cell) {
      cell_walls_[cell].push_back(wall);
      return true;
    });
  }
}

int PlainSight::column_of(double x) const noexcept {
  return static_cast<int>(std::clamp((x - low_.x) * cells_per_metre_, 0.0, columns_ - 1.0));
}
int PlainSight::row_of(double y) const noexcept {
  return static_cast<int>(std::clamp((y - low_.y) * cells_per_metre_, 0.0, rows_ - 1.0));
}

std::size_t PlainSight::cell_of(int column, int row) const noexcept {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

/// Every cell that the segment passes, row by row, widened by far more than rounding, while `visit`
/// says true.
template <class Visit>
void PlainSight::visit_cells(Vec2 from, Vec2 to, Visit visit) const {
  if (from.y > to.y) std::swap(from, to);
  const double margin = 1e-6 / cells_per_metre_;
  const double slope = to.y > from.y ? (to.x - from.x) / (to.y - from.y) : 0;
  const auto [left, right] = std::minmax(from.x, to.x);
  const int last_row = row_of(to.y + margin);
  for (int row = row_of(from.y - margin); row <= last_row; ++row) {
    double a = left, b = right;
    if (to.y > from.y) {
      const double below = low_.y + row / cells_per_metre_ - margin;
      const double above = low_.y + (row + 1) / cells_per_metre_ + margin;
      const double x0 = from.x + slope * (std::clamp(below, from.y, to.y) - from.y);
      const double x1 = from.x + slope * (std::clamp(above, from.y, to.y) - from.y);
      a = std::min(x0, x1), b = std::max(x0, x1);
    }
    const int last_column = column_of(b + margin);
    for (int column = column_of(a - margin); column <= last_column; ++column)
      if (!visit(cell_of(column, row))) return;
  }
}

bool PlainSight::sees(Vec2 from, Vec2 to) const {
  bool clear = true;
  visit_cells(from, to, [&](std::size_t cell) {
    clear = std::ranges::none_of(cell_walls_[cell],
                                 [&](std::uint32_t wall) { return is_blocked_by(wall, from, to); });
    return clear;
  });
  return clear;
}

/// Is there floor just beside the vertex in the direction of a point? Along a wall counts.
bool PlainSight::leaves_into_floor(std::uint32_t vertex, Vec2 towards) const {
  const Vec2 at = plan_.vertex[vertex];
  const Vec2 before = plan_.vertex[previous_[vertex]], after = plan_.vertex[plan_.next[vertex]];
  const bool left_of_first = orientation(before, at, towards) >= 0;
  const bool left_of_second = orientation(at, after, towards) >= 0;
  return orientation(before, at, after) >= 0 ? left_of_first && left_of_second
                                             : left_of_first || left_of_second;
}

/// A wall blocks what crosses it, and what passes its first vertex from the floor to the outside.
bool PlainSight::is_blocked_by(std::uint32_t wall, Vec2 from, Vec2 to) const {
  const Vec2 a = wall_start(plan_, wall), b = wall_end(plan_, wall);
  const int side_a = orientation(from, to, a), side_b = orientation(from, to, b);
  if (side_a == 0) {
    const bool on_segment = dot(a - from, a - to) <= 0;
    if (on_segment && a != to && !leaves_into_floor(wall, to)) return true;
    if (on_segment && a != from && !leaves_into_floor(wall, from)) return true;
    return false;
  }
  return side_a * side_b < 0 && orientation(a, b, from) * orientation(a, b, to) < 0;
}

}  // namespace docent::bench
