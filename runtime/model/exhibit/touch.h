#pragma once

#include "runtime/model/geometry/vec2.h"
#include "runtime/model/motion/side.h"

namespace docent {

/// A hand laid on an exhibit from where a guide stands beside it, as the compiler found it. World
/// frame, but for `body`.
struct Touch {
  Side beside = Side::Left;  ///< Of the line along which one looks at the exhibit: it stands there.
  Side hand = Side::Right;
  Placement body;  ///< Where it stands. Floor frame.
  Vec3 palm{};     ///< Where the middle of its palm is: half a hand's thickness off the surface.
  Vec3 fingers{};  ///< Where the fingers point, ...
  Vec3 thumb{};    ///< ... the thumb, ...
  Vec3 normal{};   ///< ... and the surface. Unit vectors.
  Vec3 ready{};    ///< Before the body, from where the palm goes there, and to where it comes back.
  float lean = 0;  ///< Radians by which the trunk leans forwards: 0 to most_lean.

  static constexpr float most_lean = 0.3F;
  static constexpr double farthest = 2;  ///< Metres from the body to the palm, and that to `ready`.
  static constexpr double highest = 2.5;  ///< Metres of the palm above the floor.
};

}  // namespace docent
