#pragma once

#include <span>

#include "content/motion/joint_positions.h"

namespace docent::motion::offline {

/// Finds in which frames each foot's toe joint rests on the ground, and writes `clip.plants`.
///
/// A foot is put down when its toe joint is low and slow, and lifted when it is clearly high or
/// fast (hysteresis), so a plant neither flickers nor ends while the heel is already rising. Low is
/// measured from where that foot rests in this clip, because the floor of a recording lies some
/// centimetres off. Clips without feet get no plants.
void find_foot_plants(const Skeleton& skeleton, const JointPositions& track, MotionClip& clip);

/// The height at which planted toe joints rest, the mean of both feet's medians; 0 without plants.
double planted_height(const Skeleton& skeleton, const JointPositions& track,
                      const MotionClip& clip);

/// The height, metres, at which planted toe joints are to rest so that clips stand on one floor,
/// y = 0. `heights` has each clip's planted_height.
///
/// The recordings' own floor is right on average (a laboratory is calibrated), so the clips are
/// levelled to the median of their planted heights. Where that is no height for a toe joint, the
/// recordings' floor was wrong, and the toe joints are put 2.5 cm up, times size_of the body.
double rest_height(const Skeleton& skeleton, std::span<const double> heights);

/// Moves a clip up by so many metres, unless that is less than can be measured.
void level_ground(double up, MotionClip& clip);

}  // namespace docent::motion::offline
