#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "content/import/drawing/arrangement.h"

namespace docent::import {

/// Parts lines into those that lie together; the members of each, largest box first.
std::vector<std::vector<std::uint32_t>> parts_that_lie_together(std::span<const WallLine> lines);

}  // namespace docent::import
