#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/path/tour/tour_costs.h"

namespace docent::path {

/// Which places are visited first and last; the others as is shortest. Where nothing is said of the
/// last, a tour may end anywhere.
struct TourEnds {
  std::optional<std::uint32_t> first{}, last{};
};

/// The places in the order in which they are visited, without the beginning.
struct TourOrder {
  std::vector<std::uint32_t> order;
  double cost = infinity;  ///< From the beginning to the last place; infinity where there is none.
  bool optimal = false;    ///< Proved: no order costs less.
};

/// What a tour in this order costs.
double cost_of(const TourCosts& costs, std::span<const std::uint32_t> order) noexcept;

/// How many places are ordered exactly.
inline constexpr std::size_t most_exact_places = 13;

/// The cheapest order in which all places are visited once: exact up to `most_exact_places`, beyond
/// that found by improving (improve_order.h) and said not to be proved. The same costs always give
/// the same order. Of no places the order is empty and costs nothing.
TourOrder shortest_order(const TourCosts& costs, const TourEnds& ends);

/// The same by the dynamic programme of Bellman, Held and Karp (1962) over all sets of places:
/// always exact, in time and memory that grow as 2^places.
TourOrder exact_order(const TourCosts& costs, const TourEnds& ends);

}  // namespace docent::path
