#pragma once

#include <memory>
#include <optional>
#include <span>

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"
#include "runtime/path/floor_map.h"

namespace docent::compile {

/// A place may lie this far from where one can stand, metres: in a wall, or behind one.
inline constexpr double farthest_standing = 3;

/// Fills `museum.places`, whose floors and connections are complete: where the way to each ends is
/// the nearest point with room for the body, to which there is a way from the entrance (on the
/// kiosk's floor; empty where nobody can stand there) while nothing is closed.
void compile_places(const config::MuseumConfig& config,
                    std::span<const std::shared_ptr<const path::FloorMap>> maps,
                    std::optional<Vec2> entrance, Museum& museum, Report& report);

}  // namespace docent::compile
