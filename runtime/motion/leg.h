#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "runtime/model/motion/side.h"
#include "runtime/model/motion/skeleton.h"
#include "runtime/motion/pose.h"

namespace docent::motion {

/// Where a foot is: the toe joint (the ball of the foot) and the ankle joint's orientation.
/// World frame, metres.
struct Foot {
  Vec3 toe{};
  Quat rotation{1, 0, 0, 0};
};

/// One leg of a skeleton: the joints from the root down to the toe, in order.
struct Leg {
  static constexpr std::size_t max_joints = 16;
  std::array<std::uint32_t, max_joints> joint{};
  std::size_t hip = 0, knee = 0, ankle = 0, toe = 0;  ///< Places in `joint`; the toe is the last.
  Vec3 ankle_to_toe{};                                ///< In the ankle's frame.
  Vec3 body_left{1, 0, 0};                            ///< Across the hips, in the root's frame.
  Vec3 tip{};        ///< Toe joint to the end of the foot, in the toe's frame.
  float length = 0;  ///< Hip to ankle when straight, metres.
};

struct Legs {
  std::array<Leg, 2> leg;
  const Leg& operator[](Side side) const noexcept { return leg[index_of(side)]; }
};

/// Empty where the skeleton has no two legs of hip, knee, ankle and toe.
std::optional<Legs> find_legs(const Skeleton& skeleton);

/// Places and orientations (world) of a leg's joints in a pose.
struct LegPose {
  std::array<Vec3, Leg::max_joints> position;
  std::array<Quat, Leg::max_joints> rotation;
};

LegPose leg_pose(const Skeleton& skeleton, const Leg& leg, const PoseView& pose) noexcept;
/// The same without the toe.
LegPose shank_pose(const Skeleton& skeleton, const Leg& leg, const PoseView& pose) noexcept;

/// Where the leg's hip joint is in a pose, world frame.
Vec3 hip_of(const Skeleton& skeleton, const Leg& leg, const PoseView& pose) noexcept;

/// Where the foot is in a pose.
Foot foot_of(const Skeleton& skeleton, const Leg& leg, const PoseView& pose) noexcept;

/// Where the ankle is when the foot is there.
Vec3 ankle_of(const Leg& leg, const Foot& foot) noexcept;

/// Turns hip, knee and ankle so that the foot is where it should be (two-bone inverse kinematics in
/// closed form). The knee keeps its plane; a foot out of reach is approached with a straight leg.
void place_foot(const Skeleton& skeleton, const Leg& leg, const Foot& foot,
                PoseView& pose) noexcept;

/// The heading (floor frame, radians) of the hips: square to the line between the hip joints.
double facing(const Skeleton& skeleton, const Legs& legs, const PoseView& pose) noexcept;

}  // namespace docent::motion
