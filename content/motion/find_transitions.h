#pragma once

#include <span>
#include <vector>

#include "content/motion/capture_faults.h"
#include "content/motion/pose_distance.h"
#include "runtime/model/motion/motion_graph.h"

namespace docent::motion::offline {

/// How alike two poses must be, and how long a blend is.
struct TransitionOptions {
  /// Seconds to each side of a transition's middle: the comparison's window and the blend. Kovar,
  /// Gleicher and Pighin blend over a third of a second.
  double radius = 0.15;
  /// Poses count as alike up to the distance that a body's own motion covers in this time (seconds,
  /// the median over a class's frames), so the threshold grows with the body and its
  /// liveliness.
  double alike_within = 0.08;
  /// Seconds round a transition within which no other between the same clips is kept.
  double apart = 0.06;
  /// Time is cut into windows of `radius` seconds; of the transitions that leave a clip in the same
  /// window, this many are kept, those of the least distance.
  std::size_t per_window = 8;
  /// Frames, of all clips together, up to which every pair of frames is compared. Of more motion
  /// only what an index of poses takes for alike is (see find_transitions).
  std::size_t compare_all_up_to = 12'000;
  /// How many poses are found in the index for one that is looked up, and how many of them are
  /// measured. With these, 97 % of what comparing all finds is found in five minutes of motion.
  std::size_t looked_up = 96, looked_closely = 64;
};

/// What transitions are judged by, one entry per clip.
struct StudiedClips {
  std::vector<PoseCloud> cloud;
  std::vector<std::vector<CaptureFault>> faults;
};

/// For each clip, the largest distance (metres) at which its poses count as alike to others: the
/// same for all clips of a class, so that what a class's graph is does not depend on the others.
std::vector<double> alike_thresholds(const std::vector<MotionClip>& clips,
                                     const StudiedClips& studied, const TransitionOptions& options);

/// Finds the transitions between clips, and within a clip: local minima of the pose distance where
/// the same feet are planted, below the larger of the two clips' `threshold`. Both directions of
/// each are judged by themselves, and returned sorted as MotionGraph wants them.
///
/// A blend's radius is shortened where it would reach over the end of a clip (section 3.1.3 of the
/// founding paper), down to half; windows that touch a fault of capture are left out.
///
/// Of much motion, only pieces of the distance matrix are measured in which an index of poses
/// (alike_tiles) finds a pair that is alike. What is found there is exactly what the whole matrix
/// has there; where very many poses are alike, some transitions are missed. Works on `jobs`
/// threads; the result does not depend on how many.
std::vector<Transition> find_transitions(const std::vector<MotionClip>& clips,
                                         const StudiedClips& studied,
                                         std::span<const double> threshold,
                                         const TransitionOptions& options, unsigned jobs);

}  // namespace docent::motion::offline
