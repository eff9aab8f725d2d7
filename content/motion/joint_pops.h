#pragma once

#include <string>
#include <vector>

#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::motion::offline {

/// Frames in which a joint turns as no joint can: its markers swapped, or its angles ran through a
/// pole. It need not move anything far: a thumb's tip stays within its hand.
struct JointPop {
  std::uint32_t first = 0, last = 0;  ///< Frames, both included.
  std::size_t joint = 0;
  double acceleration = 0;  ///< The largest; rad/s2.
};

/// The pops of a clip, by joint and frame. Nothing that a human does turns a joint faster than a
/// snap of the fingers, 28,000 rad/s2 (Acharya, Challita, Ilton and Bhamla 2021); above 30,000 it
/// is a pop. At 60 frames a second and fewer none can be told.
std::vector<JointPop> find_joint_pops(const Skeleton& skeleton, const MotionClip& clip);

/// Mends those that last no longer than 0.25 s: the joint turns smoothly from the last sound frame
/// to the next, at most a quarter as fast, or, where that takes more than a tenth of a second on
/// either side, stays as it was recorded. All other joints keep what was recorded. Returns what was
/// mended.
std::vector<JointPop> mend_joint_pops(const Skeleton& skeleton, MotionClip& clip);

/// "joint 'LThumb' pops in frames 14 to 16", for reports.
std::string describe(const JointPop& pop, const Skeleton& skeleton);

}  // namespace docent::motion::offline
