#pragma once

#include <cmath>

#include "runtime/model/geometry/vec2.h"

namespace docent::motion {

/// A placement taken as a rigid motion of the floor: it carries the origin, facing east, to there.

inline Vec2 turned(Vec2 v, double angle) noexcept {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// The motion `inner` first, then `outer`.
inline Placement compose(const Placement& outer, const Placement& inner) noexcept {
  return {outer.position + turned(inner.position, outer.heading), outer.heading + inner.heading};
}

inline Placement inverse(const Placement& motion) noexcept {
  return {turned(-motion.position, -motion.heading), -motion.heading};
}

/// A turn of the floor about the vertical, as a rotation of the world.
inline Quat world_rotation(double heading) noexcept {
  return glm::angleAxis(static_cast<float>(heading), Vec3(0, 1, 0));
}

/// A world point carried along by a motion of the floor; its height stays.
inline Vec3 moved(const Placement& motion, Vec3 point) noexcept {
  const Vec2 p = motion.position + turned(Vec2(point.x, -point.z), motion.heading);
  return to_world(p, point.y);
}

}  // namespace docent::motion
