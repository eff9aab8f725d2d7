#pragma once

#include <optional>
#include <span>
#include <vector>

#include "config/museum_config.h"
#include "content/compile/compile_floor.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// A floor as it is drawn: exhibits that stand free are drawn themselves, and not as a wall about
/// what they take.
struct DrawnFloor {
  FloorPlan plan;
  std::vector<Standing> standing;
};
DrawnFloor drawn_floor(const CompiledFloor& compiled);

/// Builds what is drawn of every floor, once its plan, exhibits and images are in the museum.
/// `config` says what rooms are paved with; null for plans without a museum. `texel`: metres of a
/// texel of light, where it is not to be seen.
void compile_scenery(const config::MuseumConfig* config, std::span<const DrawnFloor> drawn,
                     Museum& museum, std::optional<double> texel = {});

}  // namespace docent::compile
