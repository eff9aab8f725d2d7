#pragma once

#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "runtime/model/scenery.h"

namespace docent::scenery {

/// A convex polygon of the floor frame, counter-clockwise.
using Outline = std::vector<Vec2>;

/// Gathers triangles by surface and exhibit. Heights are metres above the floor.
class MeshBuilder {
 public:
  /// What the following faces are made of, and the exhibit that they belong to; -1: none.
  void use(Surface surface, std::int32_t exhibit = -1);

  /// A flat four-sided face, corners counter-clockwise seen from outside, world frame.
  void quad(const std::array<Vec3, 4>& corners, const std::array<std::array<float, 2>, 4>& uv = {});
  /// A triangle, corners counter-clockwise seen from outside, with the given normal at all three.
  void triangle(const std::array<Vec3, 3>& corners, Vec3 normal);
  /// A vertical face from `a` to `b` (left to right as it is seen), from the first of the ascending
  /// `heights` to the last, with an edge at each.
  void wall(Vec2 a, Vec2 b, std::span<const double> heights);
  /// The sides of a prism, each as `wall` makes it; `smooth` shades them as one round face.
  void sides(const Outline& outline, std::span<const double> heights, bool smooth = false);
  /// A slope from one outline to another with as many corners: a bevel, a step.
  void slope(const Outline& low, double low_height, const Outline& high, double high_height);
  /// A level face that looks up; the outline is convex.
  void lid(const Outline& convex, double height);

  /// Opacity, of 255, of the glass made from now on (SceneryVertex::sky).
  void glass_opacity(std::uint8_t opacity) { sky_ = opacity; }
  /// Likewise the tint of floor (floor_tint.h).
  void floor_tint(std::uint8_t tint) { sky_ = tint; }

  /// Everything gathered, in the order of surface and exhibit.
  Scenery finish() &&;

 private:
  std::uint32_t vertex(Vec3 position, Vec3 normal, std::array<float, 2> uv = {});

  std::vector<SceneryVertex> vertices_;
  std::map<std::pair<Surface, std::int32_t>, std::vector<std::uint32_t>> parts_;
  std::vector<std::uint32_t>* indices_ = nullptr;
  std::uint8_t sky_ = 255;
};

/// The outline with every side moved inwards by `distance` metres; outwards where it is negative.
Outline inset(const Outline& outline, double distance);

/// A rectangle about `centre`: `half` across and along `heading`.
Outline rectangle(Vec2 centre, double heading, Vec2 half);

}  // namespace docent::scenery
