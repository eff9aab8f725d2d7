#pragma once

#include <array>

#include "runtime/scene/camera.h"
#include "runtime/scene/draw_list.h"

namespace docent::scene {

inline constexpr std::array all_sides{Side::Bottom, Side::Left, Side::Top, Side::Right};

/// Is the glass as wide from there as it is high from below?
constexpr bool is_at_end(Side side) noexcept {
  return side == Side::Left || side == Side::Right;
}

/// A point of the screen frame, from a point of the glass as it is seen from a side: [0, 1] by
/// [0, 1], origin at the upper left for who stands there.
constexpr ScreenPoint to_screen(Side side, ScreenPoint at) noexcept {
  switch (side) {
    case Side::Bottom:
      return at;
    case Side::Left:
      return {1 - at.y, at.x};
    case Side::Top:
      return {1 - at.x, 1 - at.y};
    case Side::Right:
      return {at.y, 1 - at.x};
  }
  return at;
}

/// The same the other way.
constexpr ScreenPoint as_seen_from(Side side, ScreenPoint at) noexcept {
  switch (side) {
    case Side::Bottom:
      return at;
    case Side::Left:
      return {at.y, 1 - at.x};
    case Side::Top:
      return {1 - at.x, 1 - at.y};
    case Side::Right:
      return {1 - at.y, at.x};
  }
  return at;
}

/// A rectangle that lies somewhere; an empty one lies nowhere and stays.
constexpr Rect to_screen(Side side, const Rect& rect) noexcept {
  if (side == Side::Bottom || rect.width <= 0) return rect;
  const ScreenPoint a = to_screen(side, ScreenPoint{rect.x, rect.y});
  const ScreenPoint b = to_screen(side, ScreenPoint{rect.x + rect.width, rect.y + rect.height});
  const float x = a.x < b.x ? a.x : b.x, y = a.y < b.y ? a.y : b.y;
  return is_at_end(side) ? Rect{x, y, rect.height, rect.width}
                         : Rect{x, y, rect.width, rect.height};
}

}  // namespace docent::scene
