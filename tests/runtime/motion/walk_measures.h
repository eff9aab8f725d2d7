#pragma once

#include <vector>

#include "runtime/model/motion/skeleton.h"
#include "runtime/motion/walk.h"

namespace docent::test {

/// Figures of a walk, measured on its frames alone.

/// The largest offset of the root from the path's nearest point, averaged as a vector over a second
/// so that the gait's sway cancels out; metres.
double largest_deviation(const motion::Walk& walk, const std::vector<Vec2>& path);

/// How far a toe joint wanders from where it was set down while its foot is planted, at most;
/// metres.
double largest_drift(const Skeleton& skeleton, const motion::Walk& walk);

/// How deep a toe joint gets under the lowest it has while planted; metres.
double deepest_toe(const Skeleton& skeleton, const motion::Walk& walk);

/// The quickest movements from one frame to the next, in frames [from, to).
struct Quickest {
  double root = 0;               ///< Metres a second.
  double root_change = 0;        ///< Of the root's velocity, metres a second squared.
  double joint = 0;              ///< Radians a second.
  std::vector<double> of_joint;  ///< The same of each joint.
  double joint_change = 0;       ///< Radians a second squared.
};
Quickest quickest(const motion::Walk& walk, std::size_t from, std::size_t to);
/// In all clips of a graph.
Quickest quickest(const MotionGraph& graph);

/// How many times quicker than the recorded motion a walk is where it is so most, in its root and
/// in any joint. A joint that hardly moves there may turn by 0.05 radians a second.
double haste(const Quickest& walk, const Quickest& recorded);

/// The first `frames` frames of a walk, then another that goes on from the next.
motion::Walk spliced(const motion::Walk& before, std::size_t frames, const motion::Walk& after);

}  // namespace docent::test
