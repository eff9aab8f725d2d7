#pragma once

#include <memory>
#include <span>

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"
#include "runtime/path/floor_map.h"

namespace docent::compile {

/// Puts the rooms that staff named into the museum, in their order, and looks whether their
/// outlines hold an area and lie where their floors are. `maps` has one entry per floor of the
/// config, null for those without a plan.
void compile_rooms(const config::MuseumConfig& config,
                   std::span<const std::shared_ptr<const path::FloorMap>> maps, Museum& museum,
                   Report& report);

}  // namespace docent::compile
