#pragma once

#include <span>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::import {

/// The largest circle inside a polygon with holes (outer ring first), to 2 cm or, in a polygon of
/// very many corners, to what 2,000 tries find.
struct InscribedCircle {
  Vec2 centre{};
  double radius = 0;  ///< 0 where the polygon has no inside.
};
InscribedCircle inscribed_circle(std::span<const std::vector<Vec2>> rings);

/// Inside the outer ring and in none of the holes.
bool inside(std::span<const std::vector<Vec2>> rings, Vec2 p);

}  // namespace docent::import
