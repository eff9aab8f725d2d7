#pragma once

#include <cstdint>
#include <vector>

#include "runtime/directions/directions.h"
#include "runtime/model/geometry/vec2.h"

namespace docent::interface {

/// The way from where the visitor stands, the kiosk, to what they have chosen, as views say and
/// draw it; wherever the guide is.
struct ShownWay {
  directions::Directions directions;
  /// Where the guide is, if it comes there on that way; else the kiosk's.
  std::uint32_t floor = 0;
  std::vector<Vec2> line;  ///< On that floor: to the goal, or to where one leaves the floor.
};

}  // namespace docent::interface
