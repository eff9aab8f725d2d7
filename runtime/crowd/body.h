#pragma once

#include "runtime/model/geometry/vec2.h"

namespace docent::crowd {

/// An agent as detection and planning see it: a disc on the floor with a velocity.
///
/// Frame: floor.
struct Body {
  Vec2 position{};    ///< Of the centre, metres.
  Vec2 velocity{};    ///< Metres a second.
  double radius = 0;  ///< Metres, not negative.
};

}  // namespace docent::crowd
