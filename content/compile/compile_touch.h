#pragma once

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// Marks the exhibits that staff let visitors touch, once all that is drawn and the skeleton are in
/// the museum. What a guide cannot lay a hand on is told, with why, and is pointed at instead.
void compile_touch(const config::MuseumConfig& config, Museum& museum, Report& report);

}  // namespace docent::compile
