#pragma once

#include "content/motion/joint_positions.h"

namespace docent::motion::offline {

/// Which way the hips face in a frame, from the line between the hip joints: radians,
/// counter-clockwise from east in the floor frame. Follows on from `before` without leaps.
double hip_heading(const Skeleton& skeleton, const JointPositions& track, std::size_t frame,
                   double before);

/// Where the body stands and faces in each frame of a clip, floor frame: the hips with the sway of
/// the gait taken out, by a local line fitted over two gait cycles (Hann weights; a line, so that
/// both ends of a clip are treated without lag). The headings go on without leaps of whole turns.
std::vector<Placement> extract_root_motion(const Skeleton& skeleton, const MotionClip& clip,
                                           const JointPositions& track);

/// Metres a second that the body moves over the floor in each frame.
std::vector<double> body_speed(const std::vector<Placement>& body, double frame_rate);

}  // namespace docent::motion::offline
