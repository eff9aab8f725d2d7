#pragma once

#include <memory>
#include <span>

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"
#include "runtime/path/floor_map.h"

namespace docent::compile {

/// Puts the tours that staff wrote into a museum whose floors, connections, kiosk and exhibits are
/// there: each in the order of the shortest walk from the kiosk, unless staff fixed it; and after
/// them those for who has so much time. Problems (no way, more than the promised minutes) go into
/// the report. `maps`: one a floor.
void compile_tours(const config::MuseumConfig& config,
                   std::span<const std::shared_ptr<const path::FloorMap>> maps, Museum& museum,
                   Report& report);

}  // namespace docent::compile
