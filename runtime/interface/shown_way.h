#pragma once

#include <vector>

#include "runtime/directions/directions.h"
#include "runtime/model/geometry/vec2.h"

namespace docent::interface {

/// The way from where the visitor stands, the kiosk, to what they have chosen, as views say and
/// draw it; wherever the guide is.
struct ShownWay {
  directions::Directions directions;
  std::vector<Vec2>
      line;  ///< On the kiosk's floor: to the goal, or to where one leaves that floor.
};

}  // namespace docent::interface
