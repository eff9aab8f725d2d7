#include "content/object/inflate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace docent::object {
namespace {

constexpr double cells_across = 120;

/// Where the row's line goes in and out: even and odd.
std::vector<double> crossings_of(const std::vector<std::vector<Vec2>>& rings, double y) {
  std::vector<double> at;
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y > y) != (b.y > y)) at.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
  std::ranges::sort(at);
  return at;
}

}  // namespace

Cushion::Cushion(const std::vector<std::vector<Vec2>>& rings) {
  Vec2 high{-std::numeric_limits<double>::infinity()};
  low_ = -high;
  for (const auto& ring : rings)
    for (const Vec2 p : ring) {
      low_ = glm::min(low_, p);
      high = glm::max(high, p);
    }
  cell_ = std::max(high.x - low_.x, high.y - low_.y) / cells_across;
  low_ -= Vec2{1.5 * cell_};
  columns_ = static_cast<std::size_t>(std::ceil((high.x - low_.x) / cell_)) + 2;
  rows_ = static_cast<std::size_t>(std::ceil((high.y - low_.y) / cell_)) + 2;
  squared_.assign(columns_ * rows_, 0);
  std::vector<std::size_t> inside;
  for (std::size_t row = 0; row < rows_; ++row) {
    const double y = low_.y + static_cast<double>(row) * cell_;
    const std::vector<double> at = crossings_of(rings, y);
    for (std::size_t column = 0; column < columns_; ++column) {
      const double x = low_.x + static_cast<double>(column) * cell_;
      const auto passed = std::ranges::lower_bound(at, x) - at.begin();
      if (passed % 2 == 1) inside.push_back(row * columns_ + column);
    }
  }
  // Successive over-relaxation: it has settled long before so many rounds.
  constexpr int rounds = 400;
  constexpr double over = 1.95;
  const double source = 2 * cell_ * cell_;
  for (int round = 0; round < rounds; ++round)
    for (const std::size_t i : inside) {
      const double about =
          squared_[i - 1] + squared_[i + 1] + squared_[i - columns_] + squared_[i + columns_];
      squared_[i] = std::max(0.0, squared_[i] + over * ((about + source) / 4 - squared_[i]));
    }
  highest_ = std::sqrt(std::ranges::max(squared_));
}

double Cushion::height_at(Vec2 p) const {
  const double x = std::clamp((p.x - low_.x) / cell_, 0.0, static_cast<double>(columns_ - 2)),
               y = std::clamp((p.y - low_.y) / cell_, 0.0, static_cast<double>(rows_ - 2));
  const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
  const double right = x - static_cast<double>(column), up = y - static_cast<double>(row);
  const double* cell = squared_.data() + row * columns_ + column;
  return std::sqrt((1 - up) * ((1 - right) * cell[0] + right * cell[1]) +
                   up * ((1 - right) * cell[columns_] + right * cell[columns_ + 1]));
}

}  // namespace docent::object
