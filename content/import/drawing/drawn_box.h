#pragma once

#include <limits>

#include "runtime/model/geometry/vec2.h"

namespace docent::import {

/// A box that holds all points that were added; empty at first. Metres.
struct DrawnBox {
  Vec2 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};
  void add(Vec2 p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  bool meets(const DrawnBox& other) const {
    return other.low.x <= high.x && other.low.y <= high.y && other.high.x >= low.x &&
           other.high.y >= low.y;
  }
  bool holds(Vec2 p) const {
    return p.x >= low.x && p.y >= low.y && p.x <= high.x && p.y <= high.y;
  }
};

}  // namespace docent::import
