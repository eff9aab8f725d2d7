#pragma once

#include <cmath>

#include "runtime/model/geometry/vec2.h"

namespace docent::motion {

/// A rotation as an axis times an angle in [0, pi], radians.
inline Vec3 rotation_vector(Quat q) noexcept {
  if (q.w < 0) q = -q;
  const Vec3 axis(q.x, q.y, q.z);
  const float sine = glm::length(axis);
  if (sine < 1e-7f) return 2.0f * axis;
  return axis * (2 * std::atan2(sine, q.w) / sine);
}

/// The rotation of such a vector.
inline Quat rotation_of(Vec3 vector) noexcept {
  const float angle = glm::length(vector);
  if (angle < 1e-7f)
    return glm::normalize(Quat(1, 0.5f * vector.x, 0.5f * vector.y, 0.5f * vector.z));
  return glm::angleAxis(angle, vector / angle);
}

/// The shortest rotation that turns one direction into another; none where they are opposite: no
/// limb folds so far.
inline Quat shortest_arc(Vec3 from, Vec3 to) noexcept {
  const float lengths = glm::length(from) * glm::length(to);
  if (lengths < 1e-9f) return {1, 0, 0, 0};
  const Vec3 axis = glm::cross(from, to);
  const float w = lengths + glm::dot(from, to);
  if (w < 1e-6f * lengths) return {1, 0, 0, 0};
  return glm::normalize(Quat(w, axis.x, axis.y, axis.z));
}

}  // namespace docent::motion
