#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace docent {

/// A point or direction in the floor frame: metres, x east, y north, counter-clockwise positive.
using Vec2 = glm::dvec2;
/// A point or direction in three dimensions: metres, right-handed, y up.
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Quat = glm::quat;
using Mat4 = glm::mat4;

/// The z part of the cross product: positive when `b` lies counter-clockwise of `a`.
constexpr double cross(Vec2 a, Vec2 b) noexcept {
  return a.x * b.y - a.y * b.x;
}
constexpr double dot(Vec2 a, Vec2 b) noexcept {
  return a.x * b.x + a.y * b.y;
}
/// `a` turned a quarter counter-clockwise.
constexpr Vec2 left_of(Vec2 a) noexcept {
  return {-a.y, a.x};
}

/// The world point of a floor point: floor (x, y) at height h is world (x, h, -y).
inline Vec3 to_world(Vec2 p, double height = 0) noexcept {
  return {static_cast<float>(p.x), static_cast<float>(height), static_cast<float>(-p.y)};
}
/// The floor point under a world point.
inline Vec2 to_floor(Vec3 p) noexcept {
  return {p.x, -p.z};
}

/// Where something stands on a floor and which way it faces.
struct Placement {
  Vec2 position{};
  double heading = 0;  ///< Radians, counter-clockwise from east.
};

}  // namespace docent
