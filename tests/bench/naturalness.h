#pragma once

#include <span>
#include <vector>

#include "tests/bench/tracked_motion.h"

namespace docent::bench {

/// What makes a walk look like a person's, measured on its frames alone; each on walks and on the
/// clips that they were made of in the same way.

/// Poses of recordings, for questions about what is most like them.
///
/// A pose is where all parts of a body are in the frame of its circle, and where they have got to a
/// tenth of a second later in that same frame, so that slow motion is seen, too. Poses differ by
/// the root mean square over the parts of both together, metres.
class RecordedPoses {
 public:
  explicit RecordedPoses(std::span<const TrackedMotion> recordings);

  /// From a pose of a walking body to the nearest recorded one, ten times a second.
  std::vector<double> distances(const TrackedMotion& motion) const;

 private:
  std::vector<float> poses_;
};

/// Seconds between one foot's coming down and the other's, while the body walks.
std::vector<double> step_seconds(const TrackedMotion& motion);

/// From each stride to the most similar other one of all motions: root mean square over the parts
/// of a body (in the frame of its circle) and 20 moments of the stride, metres. A stride lasts from
/// one coming down of the left foot to the next; starts and stops are left out.
std::vector<double> nearest_other_stride(std::span<const TrackedMotion> motions);

/// By how much the head's way bends within four frames at 120 a second (twice that at 60, ...): its
/// place less the middle of those four frames before and after, doubled; metres, the largest.
double head_bend(const TrackedMotion& motion);
/// When that is, seconds from the first frame.
double head_bend_time(const TrackedMotion& motion);

/// The largest angular acceleration of the knee within 0.12 s of each coming down of its foot,
/// smoothed to 20 Hz: radians a second squared.
std::vector<double> knee_jolts(const TrackedMotion& motion);

/// How far a wrist moves to and fro past the body in each stride: metres.
std::vector<double> arm_swings(const TrackedMotion& motion, Side side);

/// How far a toe joint wanders from where it stood in the middle of each plant: metres.
std::vector<double> plant_drifts(const TrackedMotion& motion);

/// Standard deviation as a share of the mean.
double variation(std::span<const double> values);

}  // namespace docent::bench
