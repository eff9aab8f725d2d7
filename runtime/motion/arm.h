#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "runtime/model/motion/side.h"
#include "runtime/model/motion/skeleton.h"
#include "runtime/motion/pose.h"

namespace docent::motion {

/// One arm of a skeleton: the joints from the first that hangs on the trunk down to the hand's tip,
/// in order.
struct Arm {
  static constexpr std::size_t most_joints = 12;
  Side side = Side::Left;
  std::array<std::uint32_t, most_joints> joint{};
  std::size_t count = 0;
  std::size_t shoulder = 0, elbow = 0, wrist = 0;  ///< Places in `joint`.
  std::optional<std::size_t> clavicle;             ///< Place in `joint`.
  JointIndex trunk = JointIndex::None;             ///< What joint[0] hangs on.
  /// How upper arm, forearm and hand are turned at rest from an arm that is stretched out to its
  /// side, palm down. Whatever the rest pose, this tells where the thumb is.
  std::array<Quat, 3> rest{};
  float upper = 0, fore = 0, hand = 0;  ///< Lengths, metres.
};

struct Arms {
  std::array<std::optional<Arm>, 2> arm;
  const std::optional<Arm>& operator[](Side side) const noexcept { return arm[index_of(side)]; }
};

/// The arms that the skeleton has: each needs a shoulder, an elbow and a wrist, in this order.
Arms find_arms(const Skeleton& skeleton);

/// How an arm is held, in the terms of a clinic. Angles in radians, all 0 where the arm hangs with
/// the thumb forward; the same numbers on both sides.
struct ArmPosture {
  /// Where the upper arm points, seen from the trunk: outwards, up, forwards. A unit vector.
  Vec3 upper{0, -1, 0};
  float twist = 0;            ///< Of the upper arm about itself, outwards positive.
  float flexion = 0;          ///< Of the elbow.
  float pronation = 0;        ///< Of the forearm; palm down is positive.
  float wrist_flexion = 0;    ///< Towards the palm.
  float wrist_deviation = 0;  ///< Towards the thumb.
  float lift = 0, reach = 0;  ///< Of the collar bone: up, forwards.
};

/// What people's joints allow (American Academy of Orthopaedic Surgeons 1965), with some left over.
namespace arm_limits {
inline constexpr float elevation = 2.6F;                  ///< Of the upper arm from hanging.
inline constexpr float extension = 0.95F;                 ///< Of the upper arm behind the body.
inline constexpr float inwards = 0.8F, outwards = 1.95F;  ///< Of a raised one from straight ahead.
inline constexpr float twist_in = 1.1F, twist_out = 1.5F;
inline constexpr float flexion = 2.5F;
inline constexpr float pronation = 1.4F;  ///< Either way.
inline constexpr float wrist_flexion = 1.1F, radial = 0.35F, ulnar = 0.55F;
inline constexpr float lift = 0.4F, reach = 0.25F;
}  // namespace arm_limits

/// The nearest posture that no joint is hurt by.
ArmPosture within_limits(const ArmPosture& posture) noexcept;

/// Points at `target` (world) from a trunk that is there: the hand lies on the line from the
/// shoulder to it, palm half up, and the elbow hangs a little. Where the joints do not allow it, as
/// nearly as they do.
ArmPosture pointing(const Skeleton& skeleton, const Arm& arm, const JointPlace& trunk,
                    Vec3 target) noexcept;

/// How a hand holds something. World frame.
struct Grip {
  Vec3 place{};           ///< Of the middle of the palm.
  Vec3 fingers{0, 0, 1};  ///< Where the fingers point, ...
  Vec3 thumb{0, 1, 0};    ///< ... and the thumb; unit vectors, as nearly as the wrist allows.
};

/// Takes hold: the palm is at the grip wherever the joints allow it, else as near as they do, and
/// the elbow hangs.
ArmPosture holding(const Skeleton& skeleton, const Arm& arm, const JointPlace& trunk,
                   const Grip& grip) noexcept;

/// The middle of the palm of an arm that is held so, from a trunk that is there. World frame.
Vec3 palm_of(const Skeleton& skeleton, const Arm& arm, const JointPlace& trunk,
             const ArmPosture& posture) noexcept;

/// Where an arm is that is held so. World frame.
struct ArmPlaces {
  Vec3 shoulder{}, elbow{}, wrist{}, palm{}, tip{};
  Vec3 faces{};  ///< Out of the palm, a unit vector.
};
ArmPlaces places_of(const Skeleton& skeleton, const Arm& arm, const JointPlace& trunk,
                    const ArmPosture& posture) noexcept;

/// Where the thumb is of a hand whose fingers and palm point so. Unit vectors square to each other.
Vec3 thumb_of(Side side, Vec3 fingers, Vec3 faces) noexcept;

/// The hand at head's height, palm towards `target` (world), waving; `seconds` since it began.
ArmPosture waving(const Skeleton& skeleton, const Arm& arm, const JointPlace& trunk, Vec3 target,
                  double seconds) noexcept;

/// The hand before the body, palm half up, going along with words; `seconds` since it began.
ArmPosture telling(double seconds) noexcept;

/// The rotations of the arm's joints, relative to their parents, in the order of Arm::joint.
using ArmRotations = std::array<Quat, Arm::most_joints>;
ArmRotations rotations_of(const Arm& arm, const ArmPosture& posture) noexcept;

}  // namespace docent::motion
