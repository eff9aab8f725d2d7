#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"
#include "runtime/motion/touch.h"
#include "runtime/path/floor_map.h"

namespace docent::compile {

/// Somebody who stands at the floor's origin; nobody without clips.
std::optional<motion::Stance> standing_body(const Museum& museum);

/// How a guide lays a hand on an exhibit, from either side (Exhibit::touches). `map`: of its floor.
std::vector<Touch> find_touches(const Museum& museum, const motion::Stance& stance,
                                std::uint32_t exhibit, const path::FloorMap& map);

/// Marks the exhibits that staff let visitors touch, but what is under glass, and finds how a guide
/// does so, once all that is drawn and the skeleton are in the museum. What a guide cannot lay a
/// hand on is told, with why, and is pointed at instead. What stands in no glass is InCase no more.
void compile_touch(const config::MuseumConfig& config, Museum& museum, Report& report);

}  // namespace docent::compile
