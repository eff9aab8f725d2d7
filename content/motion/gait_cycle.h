#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "content/motion/joint_positions.h"

namespace docent::motion::offline {

/// One stride, from where the left foot passes the right to where it does so again, in poses at
/// equal times: the "basic gait sequence" of the founding paper's section 3.2.
///
/// Model of a pose: the joints of both legs, both arms and the trunk, as many as all bodies have;
/// floor frame with height, metres, about their own middle on the floor. What a body does not have
/// lies in that middle.
struct GaitCycle {
  static constexpr std::size_t poses = 24, joints = 16;

  std::array<std::array<Vec3, joints>, poses> place{};  ///< x and y on the floor, z up.
  double seconds = 0;                                   ///< How long the stride takes.
  double metres = 0;                                    ///< How far the hips go in it.
};

/// The strides of a clip, in order; none where the legs do not swing past each other twice in 0.3
/// to 2.2 s, or not by a tenth of their length.
std::vector<GaitCycle> find_gait_cycles(const Skeleton& skeleton, const MotionClip& clip,
                                        const JointPositions& track);

/// How unlike two gaits are: the founding paper's sum over the poses of |a - T R S b|, where each
/// pose of the second is laid onto that of the first by the best translation and turn on the floor
/// and the best scale. Metres: the root mean square over the joints, summed over the poses. The
/// scale makes a child's walk equal to an adult's; it is measured on the first body's size.
double unlikeness(const GaitCycle& a, const GaitCycle& b);

/// The most typical of some cycles: the one least unlike all others. Which of them, as an index.
std::size_t basic_gait(std::span<const GaitCycle> cycles);

}  // namespace docent::motion::offline
