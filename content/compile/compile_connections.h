#pragma once

#include <memory>
#include <span>
#include <vector>

#include "config/museum_config.h"
#include "content/compile/compile_floor.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"
#include "runtime/path/route.h"

namespace docent::compile {

/// Makes the museum's connections of what staff wrote; the museum has its floors, with ordinals and
/// heights. `maps` and `floors` have one for each floor, null and empty where the plan was no use.
/// Stops where nobody can stand go into the report.
void compile_connections(const config::MuseumConfig& config,
                         std::span<const std::shared_ptr<const path::FloorMap>> maps,
                         std::span<const CompiledFloor> floors, Museum& museum, Report& report);

}  // namespace docent::compile
