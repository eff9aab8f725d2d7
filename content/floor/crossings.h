#pragma once

#include <cstdint>
#include <span>

#include "content/floor/ring_overlay.h"

namespace docent::floor {

/// How often the sides of rings cross each other between their ends.
struct Crossings {
  double count = 0;                  ///< Of all sides; an estimate where there are many sides.
  std::uint32_t ring = 0, side = 0;  ///< The side, of those judged, that crosses most others.
  std::size_t of_that_side = 0;
};

/// Judged by a few hundred sides, spread evenly: in proportion to how many sides there are.
Crossings estimate_crossings(std::span<const OverlayRing> rings);

}  // namespace docent::floor
