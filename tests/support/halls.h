#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <span>
#include <vector>

#include "runtime/model/geometry/floor_plan.h"

namespace docent::test {

/// Plans small enough to say what must be seen in them.
struct HallMaker {
  FloorPlan plan;

  /// Counter-clockwise walls round a room, or clockwise ones round something that stands in it.
  HallMaker& ring(std::span<const Vec2> points) {
    const auto first = static_cast<std::uint32_t>(plan.vertex.size());
    const auto count = static_cast<std::uint32_t>(points.size());
    plan.ring.push_back({first, count});
    plan.vertex.insert(plan.vertex.end(), points.begin(), points.end());
    for (std::uint32_t i = 0; i < count; ++i) plan.next.push_back(first + (i + 1) % count);
    return *this;
  }
  HallMaker& room(Vec2 low, Vec2 high) {
    const Vec2 points[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    return ring(points);
  }
  HallMaker& block(Vec2 low, Vec2 high) {
    const Vec2 points[] = {low, {low.x, high.y}, high, {high.x, low.y}};
    return ring(points);
  }
  HallMaker& column(Vec2 centre, double radius, int corners = 16) {
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i) {
      const double angle = -2 * std::numbers::pi * i / corners;
      points.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    return ring(points);
  }
};

}  // namespace docent::test
