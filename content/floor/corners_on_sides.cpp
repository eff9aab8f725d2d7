#include "content/floor/corners_on_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "runtime/model/geometry/segment.h"

namespace docent::floor {
namespace {

/// The corners of all rings in the cells of a grid with about one for each.
class CornerGrid {
 public:
  explicit CornerGrid(std::span<const OverlayRing> rings) {
    Vec2 high{-HUGE_VAL, -HUGE_VAL};
    std::size_t count = 0;
    for (const OverlayRing& ring : rings)
      for (const Vec2 vertex : ring.vertex)
        low_ = glm::min(low_, vertex), high = glm::max(high, vertex), ++count;
    if (count == 0) return;
    const Vec2 size = high - low_;
    largest_ = std::max({std::abs(low_.x), std::abs(low_.y), std::abs(high.x), std::abs(high.y)});
    cell_ = std::max(std::sqrt(size.x * size.y / static_cast<double>(count)),
                     std::max(size.x, size.y) / static_cast<double>(count));
    if (!(cell_ > 0)) return;
    columns_ = 1 + static_cast<std::size_t>(size.x / cell_);
    rows_ = 1 + static_cast<std::size_t>(size.y / cell_);
    sort_into_cells(rings, count);
  }

  /// How near is on a side, for the numbers of these rings.
  [[nodiscard]] double tolerance() const {
    return std::max(on_side, 4 * std::numeric_limits<double>::epsilon() * largest_);
  }

  /// Calls `visit` with every corner of the cells within the tolerance of a b, and perhaps more.
  template <typename Visit>
  void for_each_near(Vec2 a, Vec2 b, const Visit& visit) const {
    if (columns_ == 0) return;
    const double reach = tolerance() + 1e-6 * cell_;  // Rounding puts no corner beyond that.
    const std::size_t first = column_of(std::min(a.x, b.x) - reach),
                      last = column_of(std::max(a.x, b.x) + reach);
    for (std::size_t column = first; column <= last; ++column) {
      const double west = low_.x + static_cast<double>(column) * cell_ - reach;
      const auto [south, north] = heights_between(a, b, west, west + cell_ + 2 * reach);
      const std::size_t top = row_of(north + reach);
      for (std::size_t row = row_of(south - reach); row <= top; ++row)
        for (std::size_t i = first_[row * columns_ + column];
             i < first_[row * columns_ + column + 1]; ++i)
          visit(corner_[i]);
    }
  }

 private:
  void sort_into_cells(std::span<const OverlayRing> rings, std::size_t count) {
    first_.assign(columns_ * rows_ + 1, 0);
    for (const OverlayRing& ring : rings)
      for (const Vec2 vertex : ring.vertex) ++first_[cell_of(vertex) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    corner_.resize(count);
    for (const OverlayRing& ring : rings)
      for (const Vec2 vertex : ring.vertex) corner_[next[cell_of(vertex)]++] = vertex;
  }
  [[nodiscard]] std::size_t column_of(double x) const {
    const auto columns = static_cast<double>(columns_ - 1);
    return static_cast<std::size_t>(std::clamp(std::floor((x - low_.x) / cell_), 0.0, columns));
  }
  [[nodiscard]] std::size_t row_of(double y) const {
    const auto rows = static_cast<double>(rows_ - 1);
    return static_cast<std::size_t>(std::clamp(std::floor((y - low_.y) / cell_), 0.0, rows));
  }
  [[nodiscard]] std::size_t cell_of(Vec2 p) const {
    return row_of(p.y) * columns_ + column_of(p.x);
  }
  /// The least and the largest y of a b between two meridians.
  static std::pair<double, double> heights_between(Vec2 a, Vec2 b, double west, double east) {
    if (a.x > b.x) std::swap(a, b);
    const auto height_at = [&](double x) {
      return x <= a.x ? a.y : x >= b.x ? b.y : a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y);
    };
    // A meridian's wall is at all heights at once.
    if (a.x == b.x) return std::minmax(a.y, b.y);
    return std::minmax(height_at(west), height_at(east));
  }

  Vec2 low_{HUGE_VAL, HUGE_VAL};
  double cell_ = 0, largest_ = 0;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::size_t> first_;  ///< Per cell, and one more: into `corner_`.
  std::vector<Vec2> corner_;
};

}  // namespace

std::vector<CornerOnSide> corners_on_sides(std::span<const OverlayRing> rings) {
  const CornerGrid grid(rings);
  const double reach = grid.tolerance();
  std::vector<CornerOnSide> found;
  for (std::uint32_t r = 0; r < rings.size(); ++r) {
    const std::vector<Vec2>& vertex = rings[r].vertex;
    for (std::uint32_t side = 0; side < vertex.size(); ++side) {
      const Vec2 a = vertex[side], b = vertex[(side + 1) % vertex.size()];
      grid.for_each_near(a, b, [&](Vec2 corner) {
        if (corner == a || corner == b) return;
        const auto [squared, along] = nearest_on_segment(corner, a, b);
        if (squared < reach * reach && along > 0 && along < 1)
          found.push_back({r, side, along, corner});
      });
    }
  }
  const auto order = [](const CornerOnSide& c) {
    return std::tuple(c.ring, c.side, c.along, c.corner.x, c.corner.y);
  };
  std::ranges::sort(found, {}, order);
  const auto same = std::ranges::unique(found, {}, order);  // Many rings may share a corner.
  found.erase(same.begin(), same.end());
  return found;
}

}  // namespace docent::floor
