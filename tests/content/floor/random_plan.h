#pragma once

#include <rapidcheck.h>

#include <tuple>
#include <vector>

#include "tests/content/floor/plans.h"

namespace docent::test {

/// A case or column: where, how large, how many corners, how turned. Centimetres and degrees, so
/// that corners often touch, line up and lie on one circle.
using Obstacle = std::tuple<int, int, int, int, int>;

inline Points corners_of(const Obstacle& obstacle) {
  const auto [x, y, radius, corners, turned] = obstacle;
  return regular_polygon({x / 100.0, y / 100.0}, radius / 100.0, corners, turned);
}

inline rc::Gen<Obstacle> any_obstacle() {
  return rc::gen::tuple(rc::gen::inRange(-100, 1300), rc::gen::inRange(-100, 900),
                        rc::gen::inRange(5, 200), rc::gen::inRange(3, 9),
                        rc::gen::map(rc::gen::inRange(0, 12), [](int i) { return 15 * i; }));
}

inline rc::Gen<std::vector<Obstacle>> any_obstacles() {
  return rc::gen::container<std::vector<Obstacle>>(any_obstacle());
}

/// A hall of 12 by 8 m with obstacles that may overlap, touch and stick out through its walls.
inline import::ImportedPlan hall_with(const std::vector<Obstacle>& obstacles) {
  std::vector<Points> holes;
  for (const Obstacle& obstacle : obstacles) holes.push_back(corners_of(obstacle));
  return drawn(rectangle({0, 0}, {12, 8}), holes);
}

}  // namespace docent::test
