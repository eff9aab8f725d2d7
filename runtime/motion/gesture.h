#pragma once

#include <array>
#include <cstdint>

#include "runtime/motion/arm.h"
#include "runtime/motion/pose.h"

namespace docent::motion {

/// What an arm does besides walking.
enum class Gesture : std::uint8_t {
  None,
  Wave,
  Point,
  Tell,  ///< A hand that goes along with words.
  Hold,  ///< A hand on something: a handle, an object, another hand.
};

/// What an arm is to do at this moment.
struct ArmOrder {
  Gesture gesture = Gesture::None;
  Vec3 target{};       ///< World: who is waved to, or what is pointed at.
  double seconds = 0;  ///< Since the gesture began; less than before where it is another.
  Grip grip{};         ///< Of Hold.
};

/// An arm on its way from one doing to the next. It takes over place and speed of each joint and
/// loses the difference with the least jerk (Flash and Hogan 1985; Bollo 2018), whatever the walk
/// does meanwhile and however early the next order comes.
struct ArmMotion {
  /// How a joint differs from what is wanted when the doing changes: rotation vectors, radians.
  struct Difference {
    Vec3 angle{}, rate{};
    float lasts = 0;  ///< Seconds.
  };
  Gesture gesture = Gesture::None;
  double since = 1e9;  ///< Seconds since the gesture changed.
  double ordered = 0;  ///< ArmOrder::seconds of the last order.
  bool begun = false;
  std::array<Difference, Arm::most_joints> difference{};
  ArmRotations shown{}, walked{};             ///< In the last frame; what the walk had there.
  std::array<Vec3, Arm::most_joints> rate{};  ///< Of what was shown, radians a second.
};

/// So many seconds after an order, at most, a hand is where it is ordered to be.
inline constexpr double longest_change = 1.0625;

/// Poses an arm as it is ordered to be, over what the walk does with it, `seconds` after the last
/// frame. To be called once the trunk is posed. Does not allocate.
void move_arm(const Skeleton& skeleton, const Arm& arm, const ArmOrder& order, double seconds,
              ArmMotion& motion, PoseView& pose) noexcept;

}  // namespace docent::motion
