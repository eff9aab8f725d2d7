#include "content/scenery/height_field.h"

#include <algorithm>
#include <cmath>

namespace docent::scenery {

HeightField::HeightField(Vec2 low, Vec2 high, double texel)
    : low_(low),
      texel_(texel),
      width_(static_cast<std::uint32_t>(std::ceil((high.x - low.x) / texel))),
      height_(static_cast<std::uint32_t>(std::ceil((high.y - low.y) / texel))),
      metres_(std::size_t{width_} * height_) {}

/// Gives every texel whose centre lies in the convex polygon to `change`.
template <typename Change>
void HeightField::change(std::span<const Vec2> polygon, const Change& change) {
  double south = polygon[0].y;
  double north = polygon[0].y;
  for (const Vec2 p : polygon) {
    south = std::min(south, p.y);
    north = std::max(north, p.y);
  }
  const auto column = [&](double x, double limit) {
    return static_cast<std::uint32_t>(
        std::clamp(std::ceil((x - low_.x) / texel_ - 0.5), 0.0, limit));
  };
  const auto first_row = column(south - low_.y + low_.x, height_);
  const auto last_row = column(north - low_.y + low_.x, height_);
  for (std::uint32_t row = first_row; row < last_row; ++row) {
    const double y = low_.y + (row + 0.5) * texel_;
    double west = 1e30;
    double east = -1e30;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i];
      const Vec2 b = polygon[(i + 1) % polygon.size()];
      if ((a.y > y) == (b.y > y)) continue;
      const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
      west = std::min(west, x);
      east = std::max(east, x);
    }
    if (west > east) continue;
    const auto to = column(east, width_);
    for (auto x = column(west, width_); x < to; ++x) change(metres_[std::size_t{row} * width_ + x]);
  }
}

void HeightField::raise(std::span<const Vec2> polygon, double height) {
  change(polygon,
         [height](float& metres) { metres = std::max(metres, static_cast<float>(height)); });
}

void HeightField::sink(std::span<const Vec2> polygon, double height) {
  change(polygon, [height](float& metres) { metres = static_cast<float>(height); });
}

float HeightField::at(Vec2 point) const noexcept {
  const double x = (point.x - low_.x) / texel_;
  const double y = (point.y - low_.y) / texel_;
  if (!(x >= 0 && y >= 0 && x < width_ && y < height_)) return 0;
  return metres_[static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x)];
}

}  // namespace docent::scenery
