#pragma once

#include "runtime/path/floor_map.h"

namespace docent::path {

/// The way along the medial axis for a query of kind Skeleton, entered and left at the nearest
/// places that a clear straight line reaches. Both ends have room (the caller has checked).
///
/// Complete: where the floor, eroded by the radius, connects the ends, there is such a way, because
/// a point can always go straight away from its nearest wall until it is on the axis, and what of
/// the axis keeps the radius is connected within each part of the eroded floor.
Way medial_axis_way(const FloorMap& map, const RouteQuery& query);

}  // namespace docent::path
