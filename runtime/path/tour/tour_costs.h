#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/model/none.h"

namespace docent::path {

/// What it costs (seconds, or metres) to get from each place of a tour to each other. Place 0 is
/// where the tour begins; the others are what it visits. One way may cost more than the way back
/// (an escalator), and infinity says that there is none.
///
/// Invariant: no cost is negative; those that are finite are less than `most`.
struct TourCosts {
  static constexpr double most = 1e7;

  std::size_t places = 1;              ///< The beginning included.
  std::vector<double> cost{infinity};  ///< places * places, by `from`, then by `to`.

  double at(std::size_t from, std::size_t to) const noexcept { return cost[from * places + to]; }
};

/// Costs of that many places between none of which there is a way yet.
inline TourCosts no_ways_between(std::size_t places) {
  return {.places = places, .cost = std::vector(places * places, infinity)};
}

}  // namespace docent::path
