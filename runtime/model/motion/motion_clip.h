#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// What a clip does, found from its motion and not from its name.
enum class ClipRole : std::uint8_t { Walk, Start, Stop, TurnLeft, TurnRight, Other };

/// Which feet stand flat and still on the ground in a frame.
struct FootPlants {
  bool left = false, right = false;
};

/// A few seconds of motion of one skeleton at a constant rate.
///
/// World frame: metres, y up, the ground at y = 0; floor (x, y) is world (x, 0, -y). `root` and
/// `plants` have one entry per frame, `rotation` joint_count entries per frame, frame by frame:
/// joint j of frame f is rotation[f * joint_count + j], relative to its parent (the root's relative
/// to the world). The clips of a compiled museum lie on a grid (motion_grid.h).
struct MotionClip {
  std::string name;
  ClipRole role = ClipRole::Other;
  std::string motion_class;  ///< "walk" unless classified otherwise.
  double frame_rate = 120;   ///< Frames a second.
  std::uint32_t joint_count = 0;
  std::vector<Vec3> root;  ///< Position of the hips, metres.
  std::vector<Quat> rotation;
  std::vector<FootPlants> plants;
};

inline std::uint32_t frame_count(const MotionClip& clip) noexcept {
  return static_cast<std::uint32_t>(clip.root.size());
}

}  // namespace docent
