#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "runtime/model/motion/skeleton.h"

namespace docent::import {

/// Motion of a skeleton as clips and walks hold it: `rotation` has one entry per joint and frame,
/// frame by frame, relative to the joint's parent; `root` the world place of joint 0, metres.
struct MotionFrames {
  double frame_rate = 120;
  std::span<const Vec3> root;
  std::span<const Quat> rotation;
};

/// A BVH text of a motion: metres, world frame, the skeleton's own joint names, channels in the
/// order Z Y X. Angles go on from frame to frame without leaps of 360 degrees.
std::string to_bvh(const Skeleton& skeleton, const MotionFrames& motion);

/// Writes it to a file, which appears whole or not at all. Throws ContentError (Environment) where
/// the disk does not let it.
void write_bvh(const Skeleton& skeleton, const MotionFrames& motion,
               const std::filesystem::path& path);

}  // namespace docent::import
