#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/path/tour/tour_costs.h"

namespace docent::path {

/// What a place of a tour is worth, and how long one stays there.
struct TourStop {
  double weight = 1;           ///< Not negative. What weighs nothing is left out.
  double looking_seconds = 0;  ///< Not negative.
};

/// The best tour that there is time for.
struct BestTour {
  std::vector<std::uint32_t> order;  ///< Places, without the beginning. Empty: no time for any.
  double seconds = 0;                ///< Ways and stops; never more than there is time for.
  double weight = 0;
  double most_weight = 0;  ///< No tour that there is time for weighs more than this.
  bool optimal = false;    ///< Proved: none weighs more.
};

/// How many places are chosen from; who has more leaves out what is far and weighs little.
inline constexpr std::size_t most_choices = 64;
/// How many beginnings of tours are looked at, at most, for each number of stops.
inline constexpr std::size_t ordinary_beginnings = 1000;
/// Of so few places all tours are looked at, and the answer is always proved.
inline constexpr std::size_t most_exact_choices = 14;

/// The tour of the greatest weight that is over within `seconds` of beginning, walks and stops
/// together (the orienteering problem). `stops`: one a place, that of place 0 does not count. There
/// are at most `most_choices` places besides the beginning, and costs are seconds.
///
/// Beginnings of tours grow by one stop at a time. Of those that visited the same places and are at
/// the same one only the earliest goes on, and only those that may still outweigh the best tour
/// known (Righini and Salani 2008). Where there are more than `most_exact_choices` places and more
/// than `beginnings` are left, the most promising go on and the answer, which is then improved
/// (improve_choice.h), may be unproved. The same
/// question always has the same answer.
BestTour best_tour_within(const TourCosts& costs, std::span<const TourStop> stops, double seconds,
                          std::size_t beginnings = ordinary_beginnings);

}  // namespace docent::path
