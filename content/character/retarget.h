#pragma once

#include <span>

#include "content/character/fit.h"
#include "runtime/model/motion/motion_clip.h"

namespace docent::character {

/// Gives a recorded clip to a character: rotations stay, the hips move by the leg's share, planted
/// feet are planted anew, and nobody steps through the floor. `clip` has its plants
/// (content/motion/foot_plants.h); `spread` is how far the arms are held further out, radians.
MotionClip retarget(const Fit& fit, const MotionClip& clip, float spread = 0);

/// How far the arms must be held further out, radians, so that in none of these clips an elbow, a
/// forearm or a hand is inside the trunk; 0 for most. Never more than 60 degrees.
float spread_for(const Fit& fit, const SkinnedMesh& body, std::span<const MotionClip* const> clips);

/// The deepest that an elbow, forearm or hand is inside the trunk in a clip of the fitted skeleton,
/// metres; 0 or less where they are free.
float depth_in_trunk(const Skeleton& skeleton, const SkinnedMesh& body, const MotionClip& clip);

}  // namespace docent::character
