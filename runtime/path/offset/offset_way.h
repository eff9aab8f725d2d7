#pragma once

#include "runtime/path/floor_map.h"

namespace docent::path {

/// The way at a distance from the wall for a query of kind Offset. Both ends have room (the caller
/// has checked).
///
/// The way goes from the start straight to the curve at the distance from its nearest wall, follows
/// the curve with the wall on the chosen hand (Hand::Shorter: on either, whichever is shorter), and
/// goes straight to the goal. Where a room is too narrow for the distance, the medial axis takes
/// the curve's place. Where the goal's wall cannot be reached so (it is an island's, say), the way
/// crosses over along the medial axis of wide places as well; there a metre counts as
/// `crossing_weight` metres, so that the way keeps to walls where it can.
///
/// Only what the search comes to is made, and nothing beforehand: any distance costs the same.
Way offset_way(const FloorMap& map, const RouteQuery& query);

inline constexpr double crossing_weight = 3;

}  // namespace docent::path
