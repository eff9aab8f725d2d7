#include "tests/bench/walk_shapes.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace docent::bench {
namespace {

/// A curve, from parameter 0 in steps of a few millimetres, until it is so long.
std::vector<Vec2> first_part_of(const std::function<Vec2(double)>& curve, double step,
                                double length) {
  std::vector<Vec2> path{curve(0)};
  for (double t = step, left = length; left > 0; t += step) {
    const Vec2 way = curve(t) - path.back();
    const double part = std::min(1.0, left / glm::length(way));
    path.push_back(path.back() + part * way);
    left -= glm::length(way);
  }
  return path;
}

/// Draws a path by walking it: from the origin, facing east.
class Pen {
 public:
  Pen& straight(double length) {
    path_.push_back(path_.back() + length * Vec2{std::cos(heading_), std::sin(heading_)});
    return *this;
  }

  /// Along a circle that the path touches: to the left where the angle (radians) is positive.
  Pen& bend(double radius, double angle) {
    constexpr int steps = 90;
    const double turn = angle / steps, chord = 2 * radius * std::sin(std::abs(turn) / 2);
    for (int i = 0; i < steps; ++i) {
      heading_ += turn / 2;
      straight(chord);
      heading_ += turn / 2;
    }
    return *this;
  }

  [[nodiscard]] const std::vector<Vec2>& path() const { return path_; }

 private:
  std::vector<Vec2> path_{{0, 0}};
  double heading_ = 0;
};

}  // namespace

std::vector<Vec2> elliptic_arc(double length) {
  return first_part_of([](double t) { return Vec2{14 * std::sin(t), 6 * (1 - std::cos(t))}; },
                       0.002, length);
}

std::vector<WalkShape> basic_shapes() {
  constexpr double pi = std::numbers::pi;
  return {{"straight", {{0, 0}, {7, 0}}},
          {"right angle, left", {{0, 0}, {4, 0}, {4, 4}}},
          {"right angle, right", {{0, 4}, {4, 4}, {4, 0}}},
          {"U", {{0, 0}, {5, 0}, {5, 2.5}, {0, 2.5}}},
          {"S", Pen().straight(1.5).bend(1.5, pi).bend(1.5, -pi).straight(1.5).path()},
          {"zigzag", {{0, 0}, {2, 2}, {4, 0}, {6, 2}, {8, 0}}},
          {"loop", Pen().straight(3.5).bend(1.5, 2 * pi).straight(3.5).path()},
          {"doorway", {{0, 0}, {3, 0}, {3.6, 1}, {4.2, 1}, {4.8, 0}, {7.8, 0}}}};
}

std::vector<Vec2> winding_way(double length) {
  return first_part_of(
      [](double t) { return Vec2{t, 2.2 * std::sin(0.45 * t) + std::sin(0.9 * t)}; }, 0.01, length);
}

}  // namespace docent::bench
