#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "runtime/model/geometry/vec2.h"

namespace docent::crowd {

/// From a point to the nearest place of a polyline, metres; infinite where that has no point.
inline double distance_to(std::span<const Vec2> line, Vec2 point) noexcept {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 a = line[i > 0 ? i - 1 : 0], step = line[i] - a;
    const double square = dot(step, step);
    const double t = square > 0 ? std::clamp(dot(point - a, step) / square, 0.0, 1.0) : 0;
    nearest = std::min(nearest, glm::distance(point, a + t * step));
  }
  return nearest;
}

}  // namespace docent::crowd
