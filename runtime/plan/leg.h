#pragma once

#include <optional>

#include "runtime/path/building/building_map.h"
#include "runtime/plan/plan.h"

namespace docent::plan {

/// The part of a way along the floor where a body is: to its goal, or to the stop of the connection
/// by which it gets on.
struct Leg {
  path::Way way;
  Placement end;
  std::optional<Ride> then{};
  std::optional<interface::Hindrance> hindrance{};  ///< Why there is no way.
  double metres_after = 0, seconds_after = 0;       ///< From its end to the goal.
};

/// The first part of the way that takes least time over floors, or of the least way on one; the
/// body has the room that find_way() gives it.
Leg find_leg(const Museum& museum, const path::BuildingMap& building, const WalkOrder& order,
             Vec2 from);

/// The whole way over floors, with as much room for the body as there is.
path::BuildingWay find_building_way(const Museum& museum, const path::BuildingMap& building,
                                    const WalkOrder& order, Vec2 from);

/// The nearest place of the kind that an order seeks, by the time that it takes to get there over
/// floors, with what is closed just now.
struct FoundPlace {
  std::uint32_t place = none;  ///< Index into Museum::places; none where there is none at all.
  path::RouteStatus status = path::RouteStatus::NoRoute;
  std::optional<interface::Hindrance> hindrance{};
};
FoundPlace find_place(const Museum& museum, const path::BuildingMap& building,
                      const WalkOrder& order, Vec2 from);

}  // namespace docent::plan
