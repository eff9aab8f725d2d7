#pragma once

#include "runtime/model/geometry/vec2.h"

namespace docent::crowd {

/// What one avatar takes up of the floor: a disc, and where it is going.
///
/// Frame: floor (metres, seconds).
struct Body {
  Vec2 position{};
  Vec2 velocity{};    ///< Metres a second.
  double radius = 0;  ///< Metres, not negative.
};

}  // namespace docent::crowd
