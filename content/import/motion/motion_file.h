#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/model/diagnostic.h"
#include "runtime/model/motion/motion_clip.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::import {

/// How long one unit of a motion file is.
struct MotionScale {
  double metres_per_unit = 1;
  bool stated = false;  ///< By a header or by clips.toml; otherwise judged from the body's height.
};

/// What one motion file holds: a body and a few seconds of its motion.
///
/// World frame: metres, y up, the floor where the recording put it (levelling is content/motion's
/// business). `clip` has no plants and no role yet; its name is the file's name without extension.
struct RecordedMotion {
  Skeleton skeleton;
  MotionClip clip;
  MotionScale scale{};
  std::vector<Diagnostic>
      notes{};  ///< Warnings: frames dropped, bones that stretch, units guessed.
};

/// The length of one frame, as files write it (".0083333"), taken for the rate that was meant: a
/// whole number of frames a second where one is within the precision of the digits.
double frame_rate_of(double seconds_per_frame);

/// Turns rotations that follow each other into the same half of the quaternion sphere, so that
/// differences of components are differences of rotation.
void make_rotations_continuous(MotionClip& clip);

/// The world places of all joints in one frame, metres; `places` holds one entry per joint.
void place_joints(const Skeleton& skeleton, const MotionClip& clip, std::size_t frame,
                  std::vector<Vec3>& places);

}  // namespace docent::import
