#pragma once

#include <vector>

#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::motion::offline {

/// Starts and stops for recordings that have none, made of walking: a body that stands with the
/// feet side by side, as in the middle of a step, and from there plays a walk, ever faster until it
/// is as recorded; for a stop the other way round. One for each foot, where the walking is long
/// enough, and only of the roles that `clips` lack; roles, classes and plants are filled in.
///
/// Clips so made do for walking; a recorded start looks better, because here nobody shifts weight
/// before lifting a foot.
std::vector<MotionClip> made_stands(const Skeleton& skeleton, const std::vector<MotionClip>& clips);

}  // namespace docent::motion::offline
