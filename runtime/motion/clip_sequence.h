#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "runtime/motion/search.h"
#include "runtime/motion/walk_graph.h"

namespace docent::motion {

/// The clips of a motion plan played one after another, blended at the transitions: the motion
/// graph's own motion before anything is warped. Floor and world frames as in MotionClip.
struct ClipSequence {
  std::vector<Vec3> root;
  std::vector<Quat> rotation;  ///< joint_count per frame.
  std::vector<ClipFrame> source;
  std::vector<Placement> body;
  std::vector<double> effort;  ///< Metres walked since the first frame; negative in the run-up.
  std::array<std::vector<bool>, 2> contact;  ///< Per foot and frame: is it a foot plant?
  std::size_t first = 0;  ///< Frames before it are a run-up that is not shown: they tell where the
                          ///< body was when the motion begins in the middle of a clip.
};

/// Plays a motion plan. `clip_to_floor` lays the first clip onto the floor.
ClipSequence play(const WalkGraph& graph, const MotionPlan& plan, const Placement& clip_to_floor);

}  // namespace docent::motion
