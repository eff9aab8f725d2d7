#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "runtime/model/geometry/vec2.h"

namespace docent::avatar {

/// A solid as a function: negative inside, positive outside, roughly the distance to its surface in
/// metres. The shapes and the smooth union are those of I. Quilez, "Distance functions"
/// (iquilezles.org).
using DistanceField = std::function<float(Vec3)>;

inline float smoothstep(float low, float high, float value) noexcept {
  const float t = std::clamp((value - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

/// Union that fills the crease between two solids over about `k` metres.
inline float join(float a, float b, float k) noexcept {
  const float h = std::max(k - std::abs(a - b), 0.0F) / k;
  return std::min(a, b) - h * h * k * 0.25F;
}

/// Intersection that rounds the edge between two solids over about `k` metres.
inline float meet(float a, float b, float k) noexcept {
  return -join(-a, -b, k);
}

/// `a` without `b`, its new edge rounded over about `k` metres.
inline float carve(float a, float b, float k) noexcept {
  return meet(a, -b, k);
}

inline float sphere(Vec3 p, Vec3 centre, float radius) noexcept {
  return glm::length(p - centre) - radius;
}

/// Nearly a distance: exact on the surface, a little short away from it.
inline float ellipsoid(Vec3 p, Vec3 centre, Vec3 radius) noexcept {
  const Vec3 q = p - centre;
  const float k0 = glm::length(q / radius);
  const float k1 = glm::length(q / (radius * radius));
  return k1 < 1e-6F ? -std::min({radius.x, radius.y, radius.z}) : k0 * (k0 - 1) / k1;
}

/// A bone with flesh on it: the hull of two balls.
inline float tapered_capsule(Vec3 p, Vec3 a, Vec3 b, float radius_a, float radius_b) noexcept {
  const Vec3 ba = b - a;
  const float l2 = glm::dot(ba, ba);
  const float rr = radius_a - radius_b;
  const float a2 = l2 - rr * rr;
  const float il2 = 1.0F / l2;
  const Vec3 pa = p - a;
  const float y = glm::dot(pa, ba);
  const float z = y - l2;
  const Vec3 xp = pa * l2 - ba * y;
  const float x2 = glm::dot(xp, xp);
  const float y2 = y * y * l2;
  const float z2 = z * z * l2;
  const float k = std::copysign(1.0F, rr) * rr * rr * x2;
  if (std::copysign(1.0F, z) * a2 * z2 > k) return std::sqrt(x2 + z2) * il2 - radius_b;
  if (std::copysign(1.0F, y) * a2 * y2 < k) return std::sqrt(x2 + y2) * il2 - radius_a;
  return (std::sqrt(x2 * a2 * il2) + y * rr) * il2 - radius_a;
}

/// A box with rounded edges; the columns of `axes` are its own directions.
inline float rounded_box(Vec3 p, Vec3 centre, const glm::mat3& axes, Vec3 half,
                         float rounding) noexcept {
  const Vec3 local = (p - centre) * axes;
  const Vec3 q = glm::abs(local) - half + rounding;
  return glm::length(glm::max(q, Vec3{0})) + std::min(std::max({q.x, q.y, q.z}), 0.0F) - rounding;
}

/// All that lies on the side of a plane that `normal` points away from.
inline float half_space(Vec3 p, Vec3 point, Vec3 normal) noexcept {
  return glm::dot(p - point, normal);
}

}  // namespace docent::avatar
