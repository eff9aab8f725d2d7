#pragma once

#include <span>
#include <vector>

#include "runtime/model/museum.h"
#include "runtime/path/building/building_map.h"

namespace docent::path {

/// Doors that are closed for good are walls of the plan, so of a way through them no map knows. The
/// fewest of them that would have to be open for there to be a way, everything else that is closed
/// being open too; empty where that would not help. For who is told why there is none: it asks many
/// ways.
std::vector<DoorOfFloor> walled_doors_in_the_way(const Museum& museum, const BuildingMap& building,
                                                 const BuildingQuery& query);

}  // namespace docent::path
