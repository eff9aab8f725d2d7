#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "content/gait/footsteps.h"

namespace docent::gait {

/// A foot at a moment: x left, y up, z forward (of heading 0), metres and radians.
struct FootPose {
  glm::dvec3 ankle{};
  double yaw = 0;        ///< Left positive.
  double pitch = 0;      ///< Of the foot against the floor, toe up positive.
  double toe_pitch = 0;  ///< Of the toes against the floor.
};

/// Where a foot is at a time, given all its own placings in order.
///
/// In stance the foot rolls and never slides: heel strike and a turn about the heel until the foot
/// is flat, flat, then a turn about the ball of the foot until the toes leave. In swing the ball of
/// the foot takes a smooth way to its next strike with the rise and pitch of the normative curves.
FootPose foot_at(std::span<const Footstep> placings, double time);

}  // namespace docent::gait
