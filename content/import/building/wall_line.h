#pragma once

#include <optional>

#include "content/import/building/imported_building.h"

namespace docent::import {

/// The wall nearest to a point.
struct WallLine {
  Vec2 at{};     ///< The nearest point on it.
  Vec2 along{};  ///< Which way it runs there; of length 1.
  double distance = 0;
};

/// The wall of a level (an edge of a room or of an obstacle) that is nearest to a point, and no
/// farther than that. Where several are equally near, as at a corner, the longest.
std::optional<WallLine> wall_at(const ImportedLevel& level, Vec2 point, double farthest);

}  // namespace docent::import
