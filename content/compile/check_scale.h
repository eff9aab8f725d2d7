#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::compile {

/// How a plan lies beside what staff say stands on it.
struct ScaleDoubt {
  std::string message, hint;
};

/// Looks whether a plan seems to be drawn in another unit, at another place or with its axes
/// swapped. `plan`: its corners; `things`: corners of rooms, and where things stand. Metres, one
/// frame. Empty where nothing seems wrong, and where too little is said to tell. Only worth asking
/// where something stands outside of the plan.
std::optional<ScaleDoubt> scale_doubt(const std::vector<Vec2>& plan,
                                      const std::vector<Vec2>& things);

}  // namespace docent::compile
