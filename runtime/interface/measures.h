#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace docent::interface {

/// The glass as the visitor sees it, after rotation.
struct ScreenShape {
  std::uint32_t width = 1920, height = 1080;  ///< Pixels.
  float diagonal_inches = 24;
  float text_scale = 1;  ///< 1 to 2: larger letters.

  bool operator==(const ScreenShape&) const = default;
};

constexpr bool is_landscape(const ScreenShape& shape) noexcept {
  return shape.width > shape.height;
}
constexpr float aspect_ratio(const ScreenShape& shape) noexcept {
  return static_cast<float>(shape.width) / static_cast<float>(shape.height);
}

/// The interface's lengths on one screen, in pixels.
struct Measures {
  float unit = 8;     ///< 1/135 of the shorter side.
  float mm = 3.6F;    ///< A millimetre of glass.
  float margin = 48;  ///< Six units.
  float gap = 16;     ///< Two units.
  float corner = 12;  ///< A unit and a half.
  float touch = 54;   ///< Height of a control: at least 15 mm.
};

/// On a small screen a millimetre counts for less, so that letters never outgrow the picture: the
/// shorter side is taken for at least 240 mm.
inline Measures measures_of(const ScreenShape& shape) noexcept {
  const auto width = static_cast<float>(shape.width), height = static_cast<float>(shape.height);
  const float shorter = std::min(width, height);
  constexpr float mm_per_inch = 25.4F, smallest_side_mm = 240;
  const float side_mm = std::max(
      smallest_side_mm, shape.diagonal_inches * mm_per_inch * shorter / std::hypot(width, height));
  Measures m;
  m.unit = shorter / 135;
  m.mm = shorter / side_mm;
  m.margin = std::round(6 * m.unit);
  m.gap = std::round(2 * m.unit);
  m.corner = 1.5F * m.unit;
  m.touch = std::ceil(std::max(15 * m.mm, 7 * m.unit) * (0.5F + 0.5F * shape.text_scale));
  return m;
}

}  // namespace docent::interface
