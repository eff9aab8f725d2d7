#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::motion::offline {

/// Which joint takes over each joint's part when left and right change places: the one of the other
/// side by its name, whose bone in the rest pose is the joint's own as seen in a mirror that stands
/// along the middle of the body (the model frame's x = 0). Joints of the middle are their own.
///
/// Throws ContentError (about `folder`) where a joint has no such counterpart: a third arm, a body
/// with one leg longer, or one that rests askew.
std::vector<std::size_t> find_counterparts(const Skeleton& skeleton, const std::string& folder);

/// The motion in the mirror of find_counterparts: what turned left turns right, by the same angle,
/// and plants change sides. `counterpart` is what find_counterparts found. Mirrored twice, a clip
/// is what it was, but for its name.
MotionClip mirrored(const std::vector<std::size_t>& counterpart, const MotionClip& clip);

}  // namespace docent::motion::offline
