#pragma once

#include <span>

#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::motion::offline {

/// Is its rest pose, without any rotation, that of a body upright: the head well above the hips,
/// and those above the feet? In some rigs every bone points along its own axis there, and no body
/// can be read from it.
bool stands_at_rest(const Skeleton& skeleton);

/// Gives the skeleton another rest pose, that of the frame of its clips in which it stands best,
/// and rewrites the clips: no joint moves by that.
void rest_upright(Skeleton& skeleton, std::span<MotionClip* const> clips);

}  // namespace docent::motion::offline
