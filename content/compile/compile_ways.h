#pragma once

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// What visitors may choose of a way. Warns where the building has steps and no way without them
/// can be asked for; the museum's connections are there.
void compile_ways(const config::MuseumConfig& config, Museum& museum, Report& report);

}  // namespace docent::compile
