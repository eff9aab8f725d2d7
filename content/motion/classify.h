#pragma once

#include "content/motion/joint_positions.h"

namespace docent::motion::offline {

/// Metres a second below which an adult's body stands.
inline constexpr double standing_speed = 0.25;

/// What a clip does, measured on its body (sway taken out).
struct ClipMeasures {
  double first_speed = 0, last_speed = 0;  ///< m/s over the first and last quarter of a second.
  double typical_speed = 0;                ///< m/s, the median while the body moves.
  double turned = 0;                       ///< Radians from first to last, counter-clockwise.
  double airborne = 0;      ///< Share of the moving frames with neither toe nor heel down.
  double astray = 0;        ///< Share of them in which it goes aside or back.
  double lowest_hips = 0;   ///< Hips' least height over the leg's length.
  double typical_hips = 0;  ///< The same, the median while the body moves.
};

ClipMeasures measure_clip(const Skeleton& skeleton, const MotionClip& clip,
                          const JointPositions& track);

/// The role that the measures speak for: a start stands first and moves last, a stop the other way
/// round; a turn changes the heading by more than 20 degrees. What stands throughout, jumps,
/// dances, crouches, walks backwards or is of no class (motion_class_of) is Other. `size` is
/// size_of the body.
ClipRole classify(const ClipMeasures& measures, double size);

/// The class of motion that the measures speak for, by how fast it is, whether it flies and how
/// deep the hips are carried: "walk", "brisk-walk", "jog", "run", "stealthy-walk" or "other"
/// (stands, moves aside, crouches, climbs). `size` is size_of the body.
const char* motion_class_of(const ClipMeasures& measures, double size);

/// "turn-left", as reports and clips.toml write it.
const char* name_of(ClipRole role);

}  // namespace docent::motion::offline
