#pragma once

#include <string>
#include <vector>

#include "content/gait/footsteps.h"
#include "runtime/model/motion/motion_clip.h"

namespace docent::gait {

/// A clip to be made: what the walker does, and which of the plan's seconds are kept.
struct GaitRecipe {
  std::string name;
  GaitPlan plan;
  double begin = 0;          ///< Seconds of the plan's clock at the first frame.
  std::uint32_t frames = 0;  ///< At 120 a second.
};

/// Makes a walking clip of `gait_skeleton()`. World frame: metres, y up, ground at y = 0; it begins
/// over the origin and heads along +z where its plan begins. `plants` says in which frames a foot
/// is flat on the ground. The same recipe gives the same clip.
MotionClip make_gait_clip(const GaitRecipe& recipe);

/// The clips of the sample museum. Seven are as many frames long as those of the project's founding
/// paper: stand to walk 424, walk 471, walk to stand 285, turns to the left and right by 90 degrees
/// 520 and 503, by 45 degrees 441 and 444. Two more turn sharp corners, by 130 degrees.
std::vector<GaitRecipe> default_clips();

}  // namespace docent::gait
