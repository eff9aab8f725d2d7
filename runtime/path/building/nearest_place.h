#pragma once

#include <cstdint>
#include <span>

#include "runtime/model/none.h"
#include "runtime/model/place.h"
#include "runtime/path/building/building_map.h"

namespace docent::path {

/// The way to the place that is nearest by the query's metric (time, where it says none), over
/// floors, of all that answer the kind.
struct NearestPlace {
  std::uint32_t place = none;  ///< Index into the places; none where no place answers the kind.
  /// Where no place can be reached: why, of the one about which most is known.
  BuildingWay way{};
};

/// The query's own goal does not count. Of two that are equally near, the first.
NearestPlace nearest_place(const BuildingMap& building, const BuildingQuery& query,
                           std::span<const Place> places, PlaceKind kind);

}  // namespace docent::path
