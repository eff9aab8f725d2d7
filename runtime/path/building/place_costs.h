#pragma once

#include <cstdint>
#include <span>

#include "runtime/path/building/building_map.h"
#include "runtime/path/tour/tour_costs.h"

namespace docent::path {

/// A place of a building: where a tour begins, or an exhibit's viewing point.
struct BuildingPlace {
  std::uint32_t floor = 0;
  Vec2 position{};
};

/// What BuildingMap::route would cost from each place to each other, with the seconds of ways along
/// a floor as well. `kind`: its ends do not count, and its metric is time where none is given. Ways
/// between two places of a floor are found once for both directions, and those between places and
/// stops once for all pairs: of n places about n * n / 2 ways where all are on one floor.
TourCosts place_costs(const BuildingMap& building, const BuildingQuery& kind,
                      std::span<const BuildingPlace> places);

}  // namespace docent::path
