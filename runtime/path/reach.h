#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "runtime/path/route.h"

namespace docent::path {

/// One of many places, and how far it is to walk there.
struct Reached {
  std::uint32_t place = 0;  ///< Its index among those asked about.
  double length = 0;        ///< Metres of the disc's shortest way there.
};

/// The places that a disc of `radius` reaches from a point by walking `limit` metres at most,
/// nearest first; of equally near ones the first one asked about. Empty where the point itself is
/// blocked; a blocked place is not reached. Frame: floor.
///
/// Costs a shortest way for each place whose straight distance is within the limit.
std::vector<Reached> places_in_reach(const FloorMap& map, Vec2 from, std::span<const Vec2> places,
                                     double radius,
                                     double limit = std::numeric_limits<double>::infinity());

/// The place with the shortest way from a point, within the limit; none where none is reached.
///
/// Costs a shortest way for each place that is nearer in a straight line than the answer on foot.
std::optional<Reached> nearest_place(const FloorMap& map, Vec2 from, std::span<const Vec2> places,
                                     double radius,
                                     double limit = std::numeric_limits<double>::infinity());

}  // namespace docent::path
