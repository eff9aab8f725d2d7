#pragma once

#include <span>
#include <vector>

#include "runtime/model/motion/motion_graph.h"

namespace docent::motion::offline {

/// The classes of some clips of one body, with the coefficients between them (section 3.2 of the
/// founding paper): how unlike their basic gaits are (gait_cycle.h).
///
/// The basic gait is found among a class's first hundred strides. Because the scale is measured on
/// the first of two bodies, the larger value of both orders is taken. A class without a stride is
/// compared as a body whose joints are all in one point.
std::vector<MotionClass> find_motion_classes(const Skeleton& skeleton,
                                             std::span<const MotionClip> clips);

}  // namespace docent::motion::offline
