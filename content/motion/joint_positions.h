#pragma once

#include <vector>

#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::motion::offline {

/// The joints of a clip where they are in the world, all frames, metres: what is measured on a
/// motion (plants, faults, distances) is measured on these.
struct JointPositions {
  std::size_t joints = 0;
  std::vector<Vec3> place;  ///< Joint j of frame f is place[f * joints + j].

  Vec3 at(std::size_t frame, std::size_t joint) const { return place[frame * joints + joint]; }
};

JointPositions joint_positions(const Skeleton& skeleton, const MotionClip& clip);

/// How large a body is: its leg (hip to ankle) over an adult's, 0.83 m. Lengths and speeds stated
/// for adults are multiplied by it, so that a child's or a giant's motion is judged alike.
double size_of(const Skeleton& skeleton);

/// Frames in a span of time, at least one.
std::uint32_t frames_in(double seconds, double frame_rate);

}  // namespace docent::motion::offline
