#pragma once

#include <optional>
#include <span>

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "content/compile/standing.h"
#include "runtime/model/museum.h"
#include "runtime/path/route.h"

namespace docent::compile {

/// The kiosk's floor, where strollers would be.
struct AmbientFloor {
  const path::FloorMap& map;
  std::span<const Standing> standing;
  std::optional<Vec2> kiosk;  ///< Empty where nobody can stand there.
  double body_radius = 0.25;
};

/// The strollers as staff want them. Into the report go more strollers than there is room for, and
/// entrances where nobody can stand or from where nobody gets to the kiosk.
Ambient compile_ambient(const config::MuseumConfig& config, const AmbientFloor& floor,
                        Report& report);

}  // namespace docent::compile
