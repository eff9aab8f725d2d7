#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/path/tour/best_tour.h"

namespace docent::path {

/// A tour that there is time for, made to weigh more where that is easy: the order is shortened,
/// then what still fits is put in where it costs least, then stops are exchanged for others that
/// weigh more, or as much in less time, until nothing gets better.
std::vector<std::uint32_t> improve_choice(const TourCosts& costs, std::span<const TourStop> stops,
                                          double seconds, std::vector<std::uint32_t> order);

}  // namespace docent::path
