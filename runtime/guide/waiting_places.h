#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/model/exhibit/exhibit.h"
#include "runtime/path/route.h"

namespace docent::guide {

/// Where guides wait for visitors: the first at `kiosk`, the others near it and in sight of it,
/// with a wall behind them and room to pass in front of them. Bodies of `radius` (metres) there are
/// an arm's length from each other and from bodies at `keep_clear`. At most `count`; fewer where
/// the room is too small. Frame: floor.
std::vector<Placement> waiting_places(const path::FloorMap& map, const Placement& kiosk,
                                      std::size_t count, double radius,
                                      std::span<const Vec2> keep_clear);

}  // namespace docent::guide
