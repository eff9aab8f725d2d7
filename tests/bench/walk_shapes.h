#pragma once

#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::bench {

/// A path to walk along. Floor frame, metres.
struct WalkShape {
  std::string name;
  std::vector<Vec2> path;
};

/// The beginning of the ellipse that the founding paper walks along: x = 14 sin t, y = 6 (1 - cos
/// t), from t = 0.
std::vector<Vec2> elliptic_arc(double length = 33);

/// What the ways through a museum are made of (the paper's Figure 8): straight, right angles to
/// either side, U, S, zigzag, loop and the jog through a doorway.
std::vector<WalkShape> basic_shapes();

/// A way that winds on for as long as wanted, in bends of radii from 0.9 m.
std::vector<Vec2> winding_way(double length);

}  // namespace docent::bench
