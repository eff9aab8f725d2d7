#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/model/exhibit/exhibit.h"
#include "runtime/path/route.h"

namespace docent::guide {

/// Where guides wait for visitors: the first at `kiosk`, the others near it and in sight of it,
/// with a wall behind them, room to pass in front of them, an arm's length apart from each other
/// and from all of `keep_clear`. At most `count`; fewer where the room is too small.
std::vector<Placement> waiting_places(const path::FloorMap& map, const Placement& kiosk,
                                      std::size_t count, double radius,
                                      std::span<const Vec2> keep_clear);

}  // namespace docent::guide
