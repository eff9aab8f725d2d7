#pragma once

#include <span>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "content/gait/balance.h"
#include "content/gait/foot_motion.h"

namespace docent::gait {

/// What paces the body through a clip, by frame.
struct Pace {
  FrameTimes times;
  std::vector<double> cycle;    ///< Whole at the left foot's strikes, and a half at the right's.
  std::vector<double> vigour;   ///< 0 standing to 1 in full steps: scales all that swings.
  std::vector<double> heading;  ///< Radians: where the pelvis faces (footsteps.h).
  std::vector<double> lean;     ///< Radians, positive to the left: into the bend.
  Loading loading;
};
Pace pace_of(std::span<const Footstep> steps, const FrameTimes& times);

/// How the trunk, the head and the arms are held in a frame: rotations in the world frame, those of
/// the arms relative to their parents.
struct UpperBody {
  glm::dquat pelvis, spine, chest, neck, head;
  glm::dquat collar[2], shoulder[2], elbow[2], wrist[2];  ///< Left, right.
};
UpperBody upper_body_at(const Pace& pace, std::size_t frame, std::uint32_t seed);

/// A leg in a frame: rotations in the world frame.
struct LegRotations {
  glm::dquat thigh, shin, foot, toes;
  double knee = 0;  ///< Flexion, radians.
};
/// Reaches from a hip joint to a foot with the knee forward between pelvis and toes.
LegRotations reach(const glm::dvec3& hip, const FootPose& foot, double pelvis_heading);

/// Where the root is in every frame (world frame, metres): over the feet as balance.h has it, and
/// as high as the legs that bear the weight hold it at their normative knee flexion, but never out
/// of reach of a foot.
std::vector<glm::dvec3> root_places(std::span<const Footstep> steps, const Pace& pace,
                                    std::uint32_t seed);

/// The placings of one foot, in order.
std::vector<Footstep> placings_of(std::span<const Footstep> steps, Side foot);

}  // namespace docent::gait
