#pragma once

#include <memory>
#include <span>

#include "runtime/model/geometry/floor.h"
#include "runtime/path/way.h"

namespace docent::path {

/// A floor made ready for queries: what the database holds plus the indices that are quick to
/// rebuild. Any thread may ask. Borrows the floor, which must outlive it.
class FloorMap;

/// Makes a floor ready for queries.
std::shared_ptr<const FloorMap> make_floor_map(const Floor& floor);

/// Answers one query. Defined for every input, also for numbers that are not finite.
Way route(const FloorMap& map, const RouteQuery& query);

/// A tour that passes the given points in the order given: the ways between them, one after
/// another.
///
/// Costs one query for each stop after the first. The order is not improved: the tour is as long as
/// the ways together; and with the kind Offset every way keeps the wall on the same hand, so a stop
/// that lies behind may cost a round of the room.
Way tour(const FloorMap& map, const RouteQuery& query, std::span<const Vec2> stops);

/// Distance to the nearest wall (inside or out), metres.
double clearance_at(const FloorMap& map, Vec2 point) noexcept;
/// Is the point in the walkable interior?
bool is_inside(const FloorMap& map, Vec2 point) noexcept;
/// Does the segment cross no wall?
bool can_see(const FloorMap& map, Vec2 from, Vec2 to) noexcept;
/// The Voronoi region (site index) that holds the point; the nearest one where it is outside.
std::uint32_t region_at(const FloorMap& map, Vec2 point) noexcept;

}  // namespace docent::path
