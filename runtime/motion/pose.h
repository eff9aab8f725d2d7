#pragma once

#include <span>

#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"
#include "runtime/motion/walk.h"

namespace docent::motion {

/// A body at one moment: the root's place in the world and every joint's rotation relative to its
/// parent.
struct PoseView {
  Vec3 root{};
  std::span<Quat> rotation;  ///< One per joint.
};

/// The pose of a walk at a time (seconds from its first frame, clamped to its ends): interpolates
/// between frames. `rotation` must hold joint_count entries. Does not allocate.
void sample(const Walk& walk, double seconds, PoseView& pose) noexcept;
void sample(const MotionClip& clip, double seconds, PoseView& pose) noexcept;

/// World transforms of all joints: `world` holds one matrix per joint. Does not allocate.
void to_world_space(const Skeleton& skeleton, const PoseView& pose, std::span<Mat4> world) noexcept;

/// Where a joint is in a pose, and how it is turned: world frame. Does not allocate.
struct JointPlace {
  Vec3 place{};
  Quat rotation{1, 0, 0, 0};
};
JointPlace place_of(const Skeleton& skeleton, JointIndex joint, const PoseView& pose) noexcept;

/// Where a head is turned, from the body: radians, left and up positive, and how quickly that
/// changes.
struct Gaze {
  double yaw = 0, pitch = 0;
  double yaw_rate = 0, pitch_rate = 0;  ///< Radians a second.
};

/// How far people turn their heads, the spine's part included. Radians.
inline constexpr double most_gaze_yaw = 1.75, most_gaze_up = 0.5, most_gaze_down = 0.7;

/// Moves the gaze towards a wish, which is brought within what a neck allows: a critically damped
/// spring of at most 3.2 radians a second. Stable whatever time goes by.
void follow_gaze(double yaw, double pitch, double seconds, Gaze& gaze) noexcept;

/// The gaze that a body facing `heading` (floor frame) needs to look from `eye` at `target`, world.
Gaze gaze_at(Vec3 target, Vec3 eye, double heading) noexcept;

/// Turns the head as the gaze says about the world's vertical and across it; neck and spine take
/// their share. Does not allocate.
void turn_head(const Skeleton& skeleton, const Gaze& gaze, PoseView& pose) noexcept;

/// palette[j] = world[j] * inverse_bind[j]: what skinning multiplies a rest-pose vertex by.
void fill_skinning_palette(std::span<const Mat4> world, std::span<const Mat4> inverse_bind,
                           std::span<Mat4> palette) noexcept;

}  // namespace docent::motion
