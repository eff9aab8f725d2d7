#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "content/import/drawing/arrangement.h"

namespace docent::import {

/// A straight flight of stairs, as plans draw it: its treads, one beside another.
struct Flight {
  std::vector<std::uint32_t> treads;  ///< Lines, from one end of the flight to the other.
  Vec2 begin{}, end{};                ///< The middles of the first and the last.
  double width = 0;                   ///< Metres.

  Vec2 middle() const { return 0.5 * (begin + end); }
};

/// Flights among these lines, in metres: five lines or more of one length, parallel, beside one
/// another, and as far apart as treads are, 0.2 to 0.42 m, each as the last.
std::vector<Flight> find_flights(std::span<const WallLine> lines);

}  // namespace docent::import
