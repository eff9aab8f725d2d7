#pragma once

#include <vector>

#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::motion::offline {

/// A whole take as the clips that it holds: where somebody stands still, sets out, walks and stands
/// again, a start, a walk and a stop for each stretch of walking; what has standing on one side
/// only is one clip. Neighbours share a second and a half, in which each goes on in the next as it
/// was recorded; of standing half a second is kept.
///
/// A take that stands nowhere, or at one of its ends only, is the one clip that it is; so is one in
/// which nobody gets far. Plants are not kept.
std::vector<MotionClip> cut_take(const Skeleton& skeleton, const MotionClip& take);

}  // namespace docent::motion::offline
