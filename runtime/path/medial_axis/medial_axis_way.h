#pragma once

#include "runtime/path/floor_map.h"

namespace docent::path {

/// The way along the medial axis for a query of kind Skeleton, entered and left at the nearest
/// places that a clear straight line reaches. Both ends have room (the caller has checked).
///
/// Complete: if the disc can get from one end to the other at all, there is such a way. A point can
/// always go straight away from its nearest wall until it is on the axis; and the part of the axis
/// that keeps the radius is connected wherever the floor that keeps the radius is.
Way medial_axis_way(const FloorMap& map, const RouteQuery& query);

}  // namespace docent::path
