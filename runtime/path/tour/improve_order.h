#pragma once

#include <cstddef>

#include "runtime/path/tour/tour_order.h"

namespace docent::path {

/// How long an order is improved: this often it is shaken and mended, whatever the time.
inline constexpr std::size_t ordinary_kicks = 400;

/// A cheap order of any number of places: iterated local search (Lourenço, Martin and Stützle 2003)
/// by moving parts of the order elsewhere, either way round (Or 1976), by turning parts round (Lin
/// 1965) and, to leave what these cannot better, by exchanging two parts that follow one another
/// (the double bridge). Never says that it is optimal. The same costs always give the same order.
///
/// Where places can be reached in some orders only, because there is no way back, it begins with
/// one that can be walked, if there is any and the costs are those of ways (from a to c there is a
/// way wherever there are ways from a to b and from b to c).
TourOrder improve_order(const TourCosts& costs, const TourEnds& ends,
                        std::size_t kicks = ordinary_kicks);

}  // namespace docent::path
