#pragma once

#include <string>
#include <vector>

#include "content/motion/joint_positions.h"

namespace docent::motion::offline {

/// Frames in which a recording is wrong: a marker that was lost or swapped throws a joint through
/// the room faster than a body could.
struct CaptureFault {
  std::uint32_t first = 0, last = 0;  ///< Frames, both included.
  std::size_t joint = 0;              ///< The joint that is thrown farthest.
  double metres = 0;                  ///< How far it leaves its course within one frame.
};

/// Finds the faults of a clip, in order. A joint's place should be close to the middle of the
/// frames before and after; what departs from it faster than any muscle moves a hand (800 m/s2; a
/// pitcher's hand reaches about half of that) or anything a head and its trunk (250 m/s2) is a
/// fault, and so are the frames between two such leaps. A leap within a tenth of a second of an end
/// of the clip parts that end from the rest.
std::vector<CaptureFault> find_capture_faults(const Skeleton& skeleton, const MotionClip& clip,
                                              const JointPositions& track);

/// Mends the faults that last no longer than 0.15 s: the joints that throw others off their course
/// turn smoothly from the last sound frame to the next (cubic Hermite curves, which keep the speeds
/// at both), and at an end of the clip they go on as they moved, ever slower. All other joints keep
/// what was recorded. Frames are neither added nor dropped.
///
/// Brings `track` up to date, and returns what was mended, in order: find_capture_faults finds none
/// of it any more. What cannot be mended so is left as it was.
std::vector<CaptureFault> mend_capture_faults(const Skeleton& skeleton, MotionClip& clip,
                                              JointPositions& track);

/// "joint 'LeftHand' leaps by 71 cm in frames 0 to 1", for reports.
std::string describe(const CaptureFault& fault, const Skeleton& skeleton);

}  // namespace docent::motion::offline
