#pragma once

#include <vector>

#include "content/import/drawing/arrangement.h"

namespace docent::import {

/// A line that shuts a gap between wall ends.
struct Gap {
  Vec2 a{}, b{};
  bool certain =
      false;  ///< Two ends of walls face each other; else a wall's end and a wall's side.
};

constexpr double narrowest_gap = 0.55;   ///< Metres.
constexpr double widest_gap = 2.6;       ///< Between two ends of walls.
constexpr double widest_side_gap = 1.4;  ///< Between the end of a wall and the side of another.
constexpr double thickest_wall = 1.0;    ///< A wall's end is not wider.

/// Where walls end opposite to one another, or to a wall's side, with nothing between.
///
/// A wall ends where its line stops at a short line across, whose other end a line leaves backwards
/// (the two faces of a thick wall), or where a single line stops. What stands free and is smaller
/// than a wall, such as a column, has no ends.
///
/// `widest` is between two ends, `widest_side` from an end to a side. Metres.
std::vector<Gap> find_gaps(const Arrangement& arrangement, double widest = widest_gap,
                           double widest_side = widest_side_gap);

/// Lines that stop less than `reach` before another: from the end to the nearest place of it.
std::vector<Gap> find_slips(const Arrangement& arrangement, double reach);

}  // namespace docent::import
