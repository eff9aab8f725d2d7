#pragma once

#include <array>

#include "runtime/model/exhibit/touch.h"
#include "runtime/motion/arm.h"

namespace docent::motion {

/// A body that stands, and where the trunks of its arms are then (by Side). World frame.
struct Stance {
  Placement body;
  double height = 0;  ///< World y of the ground.
  std::array<JointPlace, 2> trunk{};
  Vec3 waist{};  ///< About which the trunk leans.
};
/// The same, standing somewhere else.
Stance moved_to(const Stance& stance, const Placement& body, double height) noexcept;

/// How a trunk is bent above the waist: turned to the left, then leaning to where it faces so.
/// Radians.
struct TrunkBend {
  float lean = 0, turn = 0;
};
/// That of a body with that heading, as a rotation about its waist. World frame.
Quat rotation_of(const TrunkBend& bend, double heading) noexcept;
/// The same with the trunk leaning forwards by so many radians.
Stance leaned(const Stance& stance, float lean) noexcept;

/// Bends a pose at the waist; legs stay as they are.
void bend_trunk(const Skeleton& skeleton, const TrunkBend& bend, PoseView& pose) noexcept;

/// Seconds that a touch takes, from a hanging hand to `ready` again...
inline constexpr double touch_seconds = 6.2;
/// ... and from when to when the palm is on the surface.
inline constexpr double touch_begins = 2.1, touch_ends = 5.2;

/// How the hand lies there.
Grip grip_of(const Touch& touch) noexcept;
/// Where the hand is to be so many seconds after it was first sent there: to `ready`, along an arc
/// onto the surface, where it rests, and back.
Grip grip_after(const Touch& touch, double seconds) noexcept;
/// How far the trunk leans forwards then.
float lean_after(const Touch& touch, double seconds) noexcept;

}  // namespace docent::motion
