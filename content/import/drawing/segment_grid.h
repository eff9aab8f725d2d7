#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::import {

/// Finds what lies near a place: each thing is kept in all cells that its box touches.
class SegmentGrid {
 public:
  explicit SegmentGrid(double cell) : cell_(cell) {}

  void add(std::uint32_t index, Vec2 a, Vec2 b) {
    each_cell(a, b, 0, [&](std::uint64_t key) { cells_[key].push_back(index); });
  }

  /// Calls `found(index)` for all within `reach` of the segment, perhaps several times, and for
  /// some that are not.
  template <typename Found>
  void near(Vec2 a, Vec2 b, double reach, const Found& found) const {
    each_cell(a, b, reach, [&](std::uint64_t key) {
      if (const auto cell = cells_.find(key); cell != cells_.end())
        for (const std::uint32_t index : cell->second) found(index);
    });
  }

 private:
  /// The cells along the segment: row by row, so that a long diagonal touches few.
  template <typename Visit>
  void each_cell(Vec2 a, Vec2 b, double reach, const Visit& visit) const {
    if (a.y > b.y) std::swap(a, b);
    const std::int64_t first = index(a.y - reach), last = index(b.y + reach);
    for (std::int64_t row = first; row <= last; ++row) {
      const double low = static_cast<double>(row) * cell_ - reach;
      const double high = static_cast<double>(row + 1) * cell_ + reach;
      double from = 0, to = 1;
      if (b.y > a.y) {
        from = std::clamp((low - a.y) / (b.y - a.y), 0.0, 1.0);
        to = std::clamp((high - a.y) / (b.y - a.y), 0.0, 1.0);
      }
      const double x0 = a.x + from * (b.x - a.x), x1 = a.x + to * (b.x - a.x);
      const std::int64_t left = index(std::min(x0, x1) - reach);
      const std::int64_t right = index(std::max(x0, x1) + reach);
      for (std::int64_t column = left; column <= right; ++column)
        visit((static_cast<std::uint64_t>(row) << 32U) ^
              (static_cast<std::uint64_t>(column) & 0xffffffffU));
    }
  }
  std::int64_t index(double x) const { return static_cast<std::int64_t>(std::floor(x / cell_)); }

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace docent::import
