#pragma once

#include "runtime/model/motion/skeleton.h"

namespace docent::gait {

/// The measures of the walker, metres: an adult of 1.70 m. Thigh, shin, upper arm, forearm and the
/// ankle's height are the shares of stature of Drillis and Contini (1966; in Winter 2009, figure
/// 4.1); the other measures are our own, chosen for this body.
namespace walker {
inline constexpr double stature = 1.70;
inline constexpr double thigh = 0.245 * stature;
inline constexpr double shin = 0.246 * stature;
inline constexpr double hip_half = 0.084;       ///< Half the distance between the hip joints.
inline constexpr double hip_drop = 0.055;       ///< Hip joints below the root.
inline constexpr double ankle_height = 0.066;   ///< Of the ankle over the sole.
inline constexpr double ball_height = 0.025;    ///< Of the toe joint over the sole.
inline constexpr double ankle_to_ball = 0.132;  ///< Along the foot.
inline constexpr double heel_behind = 0.058;    ///< The heel's ground contact behind the ankle.
inline constexpr double toe_length = 0.062;
inline constexpr double toe_tip_height = 0.017;
}  // namespace walker

/// Joints of the walker in the order of `gait_skeleton()`; end sites follow their bones.
enum class WalkerJoint : std::uint8_t {
  Hips,
  Spine,
  Chest,
  Neck,
  Head,
  HeadTop,
  LeftCollar,
  LeftShoulder,
  LeftElbow,
  LeftWrist,
  LeftHandTip,
  RightCollar,
  RightShoulder,
  RightElbow,
  RightWrist,
  RightHandTip,
  LeftHip,
  LeftKnee,
  LeftAnkle,
  LeftToe,
  LeftToeTip,
  RightHip,
  RightKnee,
  RightAnkle,
  RightToe,
  RightToeTip,
  Count
};

/// The skeleton of the project's own clips, the walker's. Metres. Its rest pose stands upright with
/// hanging arms, facing +z; the root is between the hips.
Skeleton gait_skeleton();

}  // namespace docent::gait
