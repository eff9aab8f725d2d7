#pragma once

#include <string>
#include <vector>

#include "content/motion/track.h"

namespace docent {

/// Frames in which a recording is wrong: a marker that was lost or swapped throws a joint through
/// the room faster than a body could.
struct CaptureFault {
  std::uint32_t first = 0, last = 0;  ///< Frames, both included.
  std::size_t joint = 0;              ///< The joint that is thrown farthest.
  double metres = 0;                  ///< How far it leaves its course from one frame to the next.
};

/// Finds them, in order. A joint's place should be close to the middle of the frames before and
/// after; what departs from it faster than any muscle moves a hand (800 m/s2; a pitcher's hand
/// reaches about half of that) is a fault, and the frames between two such leaps with it.
std::vector<CaptureFault> find_capture_faults(const Skeleton& skeleton, const MotionClip& clip,
                                              const Track& track);

/// "joint 'LeftHand' leaps by 71 cm in frames 0 to 1", for reports.
std::string describe(const CaptureFault& fault, const Skeleton& skeleton);

}  // namespace docent
