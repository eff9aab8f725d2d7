#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "runtime/scene/draw_list.h"

namespace docent::interface {

/// At which edges of a shared glass people stand.
struct Sides {
  std::uint8_t bits = 0;  ///< One for each scene::Side. None: the glass is not shared.

  constexpr bool has(scene::Side side) const noexcept {
    return (bits >> static_cast<unsigned>(side) & 1U) != 0;
  }
  constexpr void add(scene::Side side) noexcept {
    bits = static_cast<std::uint8_t>(bits | 1U << static_cast<unsigned>(side));
  }
  constexpr int count() const noexcept { return std::popcount(bits); }
  /// People look at it from several sides, or from another than its lower edge: it lies, and does
  /// not hang.
  constexpr bool is_table() const noexcept {
    return count() > 1 || (count() == 1 && !has(scene::Side::Bottom));
  }
  bool operator==(const Sides&) const = default;
};

/// The glass as the visitor sees it, after rotation.
struct ScreenShape {
  std::uint32_t width = 1920, height = 1080;  ///< Pixels.
  float diagonal_inches = 24;
  float text_scale = 1;  ///< 1 to 2: larger letters.
  /// Millimetres of the glass's lower edge above the floor; 0: nobody has said.
  float mount_mm = 0;
  bool is_night = false;  ///< Light letters on dark paper, and a museum in the dark.
  Sides sides{};

  bool operator==(const ScreenShape&) const = default;
};

constexpr bool is_landscape(const ScreenShape& shape) noexcept {
  return shape.width > shape.height;
}
constexpr float aspect_ratio(const ScreenShape& shape) noexcept {
  return static_cast<float>(shape.width) / static_cast<float>(shape.height);
}

/// A part of the screen's height. Screen frame: 0 is the upper edge.
struct ReachableBand {
  float top = 0, bottom = 1;
};

inline float glass_height_mm(const ScreenShape& shape) noexcept {
  constexpr float mm_per_inch = 25.4F;
  const auto width = static_cast<float>(shape.width), height = static_cast<float>(shape.height);
  return shape.diagonal_inches * mm_per_inch * height / std::hypot(width, height);
}

inline constexpr float lowest_reach_mm = 380, highest_reach_mm = 1220, least_band = 0.4F;
/// Where the glass can be touched from a wheelchair, and by a child: 380 to 1,220 mm above the
/// floor (EN 301 549, chapter 8). Two fifths of the height at least, where it hangs too high.
inline ReachableBand low_reach_of(const ScreenShape& shape) noexcept {
  if (shape.mount_mm <= 0) return {};
  const float glass = glass_height_mm(shape);
  ReachableBand reach{
      std::clamp(1 - (highest_reach_mm - shape.mount_mm) / glass, 0.0F, 1 - least_band), 1};
  reach.bottom =
      std::clamp(1 - (lowest_reach_mm - shape.mount_mm) / glass, reach.top + least_band, 1.0F);
  return reach;
}

/// Does the glass hang so that some of it is out of that reach?
inline bool can_be_lowered(const ScreenShape& shape) noexcept {
  const ReachableBand reach = low_reach_of(shape);
  return reach.top > 0 || reach.bottom < 1;
}

/// Where it hangs so high that less than those two fifths are within reach: at how many millimetres
/// above the floor it would have to hang at most. None where it hangs low enough.
inline std::optional<float> mount_within_reach(const ScreenShape& shape) noexcept {
  const float most = highest_reach_mm - least_band * glass_height_mm(shape);
  return shape.mount_mm > most ? std::optional(std::max(most, 0.0F)) : std::nullopt;
}

/// The interface's lengths on one screen, in pixels.
struct Measures {
  float unit = 8;     ///< 1/135 of the shorter side; at most 2.2 mm where the glass is shared.
  float mm = 3.6F;    ///< A millimetre of glass.
  float margin = 48;  ///< Six units.
  float gap = 16;     ///< Two units.
  float corner = 12;  ///< A unit and a half.
  float touch = 54;   ///< Height of a control: at least 15 mm.
};

/// Who shares a glass stands right at it, however large it is: what lies on it is as large as on a
/// screen of 24 inches.
inline constexpr float shared_unit_mm = 2.2F;

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
  if (shape.sides.count() > 0) m.unit = std::min(m.unit, shared_unit_mm * m.mm);
  m.margin = std::round(6 * m.unit);
  m.gap = std::round(2 * m.unit);
  m.corner = 1.5F * m.unit;
  m.touch = std::ceil(std::max(15 * m.mm, 7 * m.unit) * (0.5F + 0.5F * shape.text_scale));
  return m;
}

}  // namespace docent::interface
