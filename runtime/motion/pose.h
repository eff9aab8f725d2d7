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

/// Adds breathing and slow shifts of weight to a standing pose, over planted feet. `seconds` counts
/// from when it began to stand; nothing is added at 0 and the motion never repeats exactly. Smooth
/// in time; moves the hips by at most 2 cm. Does not allocate.
void add_idle(const Skeleton& skeleton, double seconds, PoseView& pose) noexcept;

/// Turns the head by `angle` radians about the world's vertical, counter-clockwise from above; neck
/// and chest take their share. Does not allocate.
void turn_head(const Skeleton& skeleton, float angle, PoseView& pose) noexcept;

/// palette[j] = world[j] * inverse_bind[j]: what skinning multiplies a rest-pose vertex by.
void fill_skinning_palette(std::span<const Mat4> world, std::span<const Mat4> inverse_bind,
                           std::span<Mat4> palette) noexcept;

}  // namespace docent::motion
