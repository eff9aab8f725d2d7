#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "runtime/model/geometry/vec2.h"

/// The grid on which the motion of a compiled clip lies, so that a database holds it as small whole
/// numbers and still exactly (runtime/schema/motion_blob.h).
///
/// A root's place is a whole number of steps of 1/16384 m (0.06 mm) along each axis. Of a rotation
/// three parts are whole numbers of steps of 2^-(bits - 1), and the fourth, the derived part,
/// follows from the unit length. Steps are powers of two, so a float holds them exactly, and the
/// derived part is one correctly rounded square root: the same bits on every machine.
namespace docent::motion_grid {

inline constexpr double root_steps = 16384;                             ///< A metre.
inline constexpr std::int64_t most_root_steps = std::int64_t{1} << 60;  ///< Of either sign.

/// How many bits a part of a rotation may have. The fewest may move a hand by a centimetre; the
/// most are as fine as a float.
inline constexpr int least_bits = 8, most_bits = 22;

/// Steps of one part of a rotation from 0 to 1.
constexpr std::int64_t steps_of(int bits) noexcept {
  return std::int64_t{1} << (bits - 1);
}

/// The place of a root (metres), and the part of a rotation, at so many steps.
inline float root_at(std::int64_t steps) noexcept {
  return static_cast<float>(static_cast<double>(steps) / root_steps);
}
inline float part_at(std::int64_t steps, int bits) noexcept {
  return static_cast<float>(steps) / static_cast<float>(steps_of(bits));
}

/// The parts of a rotation in steps, in the order x, y, z, w.
using RotationSteps = std::array<std::int64_t, 4>;

/// The size of the derived part in steps, not rounded; negative where the other three parts are too
/// long for a unit quaternion.
inline double derived_steps(const RotationSteps& steps, std::size_t derived, int bits) noexcept {
  std::int64_t left = steps_of(bits) * steps_of(bits);  // at most 2^42: exact in a double
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (i != derived) left -= steps[i] * steps[i];
  return left < 0 ? -1 : std::sqrt(static_cast<double>(left));
}

/// The derived part, of so many steps, as a float.
inline float derived_at(double steps, int bits) noexcept {
  return static_cast<float>(steps / static_cast<double>(steps_of(bits)));
}

/// Part `i` of x, y, z, w.
inline float part_of(const Quat& q, std::size_t i) noexcept {
  return i == 0 ? q.x : i == 1 ? q.y : i == 2 ? q.z : q.w;
}
inline Quat from_parts(const std::array<float, 4>& part) noexcept {
  return Quat(part[3], part[0], part[1], part[2]);
}

}  // namespace docent::motion_grid
