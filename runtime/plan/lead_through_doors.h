#pragma once

#include <span>
#include <vector>

#include "runtime/model/museum.h"
#include "runtime/path/floor_map.h"

namespace docent::plan {

/// The way, led straight through the middle of each door with a leaf, or of its leaf: nobody pushes
/// a door open while they brush past its hinges. Where walls leave no room for that, it stays as it
/// was.
std::vector<Vec2> lead_through_doors(const Museum& museum, const path::FloorMap& map,
                                     std::span<const Vec2> way);

}  // namespace docent::plan
