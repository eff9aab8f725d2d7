#pragma once

#include <optional>

#include "runtime/path/shortest/shortest_way_map.h"
#include "runtime/path/way.h"

namespace docent::path {

/// The straight way of a disc of the map's radius between two points that keep that radius from all
/// walls (the caller has checked), if that is clear. `clearance_min` is left 0. For radius 0 it is
/// enough to have checked one end: a straight way never leaves the interior.
std::optional<Way> straight_way(const ShortestWayMap& map, Vec2 from, Vec2 to);

/// The shortest way between two such points where the straight one is not clear: Ok with length,
/// points and the radius as `clearance_min`, or NoRoute.
Way bent_way(const ShortestWayMap& map, Vec2 from, Vec2 to);

}  // namespace docent::path
