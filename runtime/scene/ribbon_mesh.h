#pragma once

#include <array>
#include <span>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::scene {

/// A vertex of a ribbon's strip.
struct RibbonVertex {
  std::array<float, 2> place{};  ///< World x and z, metres.
  std::array<float, 2>
      ribbon{};  ///< Metres along from the start (of the way's own length) and across.
};

/// Half of the ribbon, metres.
constexpr double ribbon_half_width = 0.125;
/// How far the strip reaches beyond the ribbon, for the thread of shadow round it.
constexpr double ribbon_rim = 0.035;

/// Appends a triangle strip along `points` (floor frame) to `strip`: corners rounded, half a width
/// longer at both ends for the round caps, `length` metres from the first point to the last. Stops
/// early when `strip` has no more capacity; `rounded` is working space; does not allocate. Returns
/// how many vertices were appended; 0 where there are not two different points.
std::size_t append_ribbon(std::span<const Vec2> points, double length, std::vector<Vec2>& rounded,
                          std::vector<RibbonVertex>& strip) noexcept;

}  // namespace docent::scene
