#pragma once

#include <vector>

#include "runtime/model/motion/motion_graph.h"
#include "runtime/motion/walk.h"

namespace docent::motion {

/// The greatest speeds of body and joints in recorded motion, from one frame to the next.
struct QuickestMotion {
  double root = 0;            ///< Metres a second.
  std::vector<double> joint;  ///< Radians a second.
};

QuickestMotion quickest_motion(const MotionGraph& motion);

struct WalkGraph;

/// Keeps a walk's body and every joint from being quicker than in recorded motion by more than a
/// plausible share (14 %). Joints that bear nothing (arms, head, spine) take more time for what
/// they do; where the body or a leg would be too quick the walk is played more slowly, smoothly:
/// places and what the feet do stay the same. All other frames stay as they are, and so do the
/// first and the last.
void limit_speeds(const WalkGraph& graph, Walk& walk);

}  // namespace docent::motion
