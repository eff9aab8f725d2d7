#pragma once

#include <span>
#include <vector>

#include "content/motion/pose_distance.h"
#include "runtime/model/motion/motion_clip.h"

namespace docent::motion::offline {

/// A clip that is to be registered with another; borrowed.
struct RegisteredClip {
  const MotionClip& clip;
  const PoseCloud& cloud;
  std::span<const double> heading;  ///< Of the body, radians, per frame.
};

/// Which moments of two clips belong together: the time warp of a registration curve (Kovar and
/// Gleicher 2003). Moments are frames with fractions; both clips' only go forwards, and neither
/// runs more than twice as fast as the other.
struct Registration {
  std::vector<double> a, b;  ///< One entry per moment that the clips share.
  double unlikeness = 0;     ///< Metres: how far apart poses at the same moment are, typically.
};

/// Finds the longest run of moments, from the beginning of one of the clips to the end of one, at
/// which poses are alike and the same feet are on the ground. Where both turn, they also turn
/// together: half of one's turn is done when half of the other's is.
Registration register_clips(const RegisteredClip& a, const RegisteredClip& b);

}  // namespace docent::motion::offline
