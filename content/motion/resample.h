#pragma once

#include "runtime/model/motion/motion_clip.h"

namespace docent::motion::offline {

/// The clip at another frame rate, over the same time: places and rotations on smooth curves
/// (Catmull-Rom) through the recorded frames, so that speeds have no corners. Plants are not kept.
MotionClip resample(const MotionClip& clip, double frame_rate);

}  // namespace docent::motion::offline
