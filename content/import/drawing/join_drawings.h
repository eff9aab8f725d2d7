#pragma once

#include <vector>

#include "content/import/drawing/drawing.h"

namespace docent::import {

/// Drawings of one floor, one of the walls and one of the doors, say, laid over one another. The
/// first one's unit counts; another that states another unit is brought to it.
Drawing join_drawings(std::vector<Drawing> drawings);

}  // namespace docent::import
