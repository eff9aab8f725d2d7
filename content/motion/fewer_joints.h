#pragma once

#include <cstddef>
#include <vector>

#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::motion::offline {

/// The joints that are a part of the body or carry one, in order; with the root, so that a parent
/// of any is one of them.
std::vector<std::size_t> joints_of_parts(const Skeleton& skeleton);

/// The same with these joints only, and every one of them where it was. `kept` is in order, and has
/// the parent of each. Every body part must be among them.
Skeleton with_joints(const Skeleton& skeleton, const std::vector<std::size_t>& kept);
MotionClip with_joints(const MotionClip& clip, const std::vector<std::size_t>& kept);

}  // namespace docent::motion::offline
