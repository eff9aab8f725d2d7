#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::scenery {

/// What stands on the floor, seen from above: the height (metres) over each texel of a grid. Floor
/// frame; texel (0, 0) is in the south-west corner. Beyond the grid nothing stands.
class HeightField {
 public:
  HeightField(Vec2 low, Vec2 high, double texel);

  /// Raises the texels whose centre lies in the convex counter-clockwise polygon to `height`.
  void raise(std::span<const Vec2> polygon, double height);
  /// Sets those texels to `height`: an opening in the floor.
  void sink(std::span<const Vec2> polygon, double height);

  float at(Vec2 point) const noexcept;

  std::uint32_t width() const noexcept { return width_; }
  std::uint32_t height() const noexcept { return height_; }
  double texel() const noexcept { return texel_; }
  Vec2 low() const noexcept { return low_; }
  Vec2 high() const noexcept { return low_ + Vec2(width_, height_) * texel_; }
  Vec2 centre(std::uint32_t x, std::uint32_t y) const noexcept {
    return low_ + Vec2(x + 0.5, y + 0.5) * texel_;
  }
  float texel_height(std::uint32_t x, std::uint32_t y) const noexcept {
    return metres_[std::size_t{y} * width_ + x];
  }

 private:
  Vec2 low_{};
  double texel_ = 1;
  std::uint32_t width_ = 0, height_ = 0;
  template <typename Change>
  void change(std::span<const Vec2> polygon, const Change& change);

  std::vector<float> metres_;
};

}  // namespace docent::scenery
