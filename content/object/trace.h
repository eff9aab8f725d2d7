#pragma once

#include <vector>

#include "content/object/cut_out.h"
#include "runtime/model/geometry/vec2.h"

namespace docent::object {

/// Closed lines about what a mask covers, in pixels, x to the right and y up from its lower left
/// corner: the thing's outline counter-clockwise, then its holes clockwise. None crosses itself or
/// another, and none is farther than `tolerance` from where the mask (smoothed over its next
/// pixels) covers a half: but where that would make them cross, they are nearer.
std::vector<std::vector<Vec2>> trace(const Mask& mask, double tolerance);

}  // namespace docent::object
