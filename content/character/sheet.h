#pragma once

#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"
#include "runtime/model/motion/skinned_mesh.h"
#include "runtime/model/pixels.h"

namespace docent::character {

/// A body from all sides, standing, and below it through a walk: 1600 by 1240 pixels. `skeleton`
/// and `walk` are the fitted ones.
Pixels draw_sheet(const Skeleton& skeleton, const SkinnedMesh& body, const MotionClip& walk);

}  // namespace docent::character
