#pragma once

#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::motion::offline {

/// How far a joint's end may move for the sake of a small database, metres.
inline constexpr double quantise_tolerance = 0.001;

/// Lays a clip on a motion grid (runtime/model/motion/motion_grid.h): the coarsest that moves no
/// joint's end, end sites included, by more than the tolerance in any frame. A clip that lies there
/// already is not changed by writing and reading it, so whatever is worked out from a clip is
/// worked out after this.
///
/// Rotations become unit quaternions first, and the identity stays the identity. The tolerance is
/// kept for bodies of up to a hundred metres; what is larger lies on the finest grid.
/// Deterministic.
void quantise(const Skeleton& skeleton, MotionClip& clip);

/// The largest distance, metres, between the places of one joint in two motions of a body, over all
/// frames and joints. Both have as many frames and joints.
double largest_difference(const Skeleton& skeleton, const MotionClip& a, const MotionClip& b);

}  // namespace docent::motion::offline
