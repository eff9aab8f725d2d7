#pragma once

#include "runtime/path/floor_map.h"

namespace docent::path {

/// The way at a distance from the wall for a query of kind Offset. Both ends have room (the caller
/// has checked).
///
/// From the start it goes straight to its nearest wall's curve at the distance, follows the curve
/// with the wall on the chosen hand (or every wall on the hand that is shorter), and goes straight
/// to the goal. Where the room is too narrow for the distance the medial axis takes the curve's
/// place. Where the goal's wall cannot be reached so (it is an island's, say), it crosses over
/// along the medial axis of wide places as well; there a metre counts as `crossing_weight` metres,
/// so that it keeps to walls where it can.
///
/// Nothing is made beforehand and nothing but what the search comes to: any distance costs the
/// same.
Way offset_way(const FloorMap& map, const RouteQuery& query);

inline constexpr double crossing_weight = 3;

}  // namespace docent::path
