#pragma once

#include <vector>

#include "content/motion/registration.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::motion::offline {

/// The motion between two registered clips, `share` of the way from the first to the second (Kovar
/// and Gleicher 2003): it turns by an angle, and goes at a speed, between theirs. Where a foot
/// stands in both, the body moves so that the foot stays as still as it does in them (elsewhere as
/// the hips move), so plants stay sound. Name, role and plants are left to the caller.
MotionClip blend_clips(const Skeleton& skeleton, const MotionClip& a, const MotionClip& b,
                       const Registration& registration, double share);

/// Turns between those that were recorded (Heck and Gleicher 2007), as new clips: where the angles
/// of two neighbours, of the same side and motion class, straight walks among them, are more than
/// 20 degrees apart, as many between them as leave no gap of more than 30. What cannot be
/// registered well, over two thirds of the turn at least, gives none. `cloud` has an entry per
/// clip.
std::vector<MotionClip> parametric_turns(const Skeleton& skeleton,
                                         const std::vector<MotionClip>& clips,
                                         const std::vector<PoseCloud>& cloud);

}  // namespace docent::motion::offline
