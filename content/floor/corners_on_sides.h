#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "content/floor/ring_overlay.h"

namespace docent::floor {

/// A corner of a ring that lies on a side of the same ring or of another, not at its ends.
struct CornerOnSide {
  std::uint32_t ring = 0, side = 0;  ///< The side begins at vertex `side` of `ring`.
  double along = 0;                  ///< In (0, 1), from the side's start to its end.
  Vec2 corner{};
};

/// A corner nearer than this to a side lies on it: metres. Written in decimals, a corner that is
/// meant to lie on an oblique wall misses it by a rounding error, which is neither a passage nor
/// wide enough for a disc to be found in it.
inline constexpr double on_side = 1e-9;

/// Those nearer than `on_side`, or than the numbers are apart where they are large, in the order of
/// rings, of sides, and along them.
std::vector<CornerOnSide> corners_on_sides(std::span<const OverlayRing> rings);

}  // namespace docent::floor
