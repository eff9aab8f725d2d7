#include "runtime/motion/gesture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/motion/rotation.h"

namespace docent::motion {
namespace {

/// A change takes so long: by its angle, and never so quick that it looks thrown.
constexpr float seconds_a_radian = 0.54F, quickest = 0.5F, slowest = 0.85F;
/// The hand follows the forearm, which follows the upper arm.
constexpr float lag_at_elbow = 1.1F, lag_at_wrist = 1.25F;
static_assert(longest_change >= slowest * lag_at_wrist);

Vec3 turn_between(Quat from, Quat to) noexcept {
  return rotation_vector(glm::normalize(to * glm::inverse(from)));
}

/// What is left of a difference some seconds later: a quintic that ends at rest.
Vec3 rest_of(const ArmMotion::Difference& difference, double seconds) noexcept {
  const float whole = difference.lasts, t = static_cast<float>(seconds);
  if (t >= whole) return {};
  const Vec3 x = difference.angle, v = difference.rate * whole;
  const float s = t / whole;
  return x + s * (v + s * s *
                          (-(10.0F * x + 6.0F * v) +
                           s * ((15.0F * x + 8.0F * v) - s * (6.0F * x + 3.0F * v))));
}

void change_to(const Arm& arm, Gesture gesture, const ArmRotations& wanted, double seconds,
               ArmMotion& motion) noexcept {
  motion.gesture = gesture;
  motion.since = 0;
  float most = 0;
  for (std::size_t i = 0; i < arm.count; ++i) {
    ArmMotion::Difference& difference = motion.difference[i];
    // Both as they were in the last frame: a posture stands still meanwhile, a walk goes on.
    const Quat& before = gesture == Gesture::None ? motion.walked[i] : wanted[i];
    difference.angle = turn_between(before, motion.shown[i]);
    difference.rate = motion.rate[i];
    if (seconds > 0)
      difference.rate -= turn_between(before, wanted[i]) / static_cast<float>(seconds);
    most = std::max(most, glm::length(difference.angle) + 0.1F * glm::length(difference.rate));
  }
  const float whole = std::clamp(seconds_a_radian * most, quickest, slowest);
  for (std::size_t i = 0; i < arm.count; ++i)
    motion.difference[i].lasts = whole * (i < arm.elbow   ? 1.0F
                                          : i < arm.wrist ? lag_at_elbow
                                                          : lag_at_wrist);
}

ArmRotations walked_by(const Arm& arm, const PoseView& pose) noexcept {
  ArmRotations walked;
  for (std::size_t i = 0; i < arm.count; ++i) walked[i] = pose.rotation[arm.joint[i]];
  return walked;
}

ArmRotations wanted_by(const Skeleton& skeleton, const Arm& arm, const ArmOrder& order,
                       const ArmRotations& walks, const PoseView& pose) noexcept {
  const JointPlace trunk = place_of(skeleton, arm.trunk, pose);
  switch (order.gesture) {
    case Gesture::Point:
      return rotations_of(arm, pointing(skeleton, arm, trunk, order.target));
    case Gesture::Wave:
      return rotations_of(arm, waving(skeleton, arm, trunk, order.target, order.seconds));
    case Gesture::Tell:
      return rotations_of(arm, telling(order.seconds));
    case Gesture::Hold:
      return rotations_of(arm, holding(skeleton, arm, trunk, order.grip));
    case Gesture::None:
      break;
  }
  return walks;
}

}  // namespace

void move_arm(const Skeleton& skeleton, const Arm& arm, const ArmOrder& order, double seconds,
              ArmMotion& motion, PoseView& pose) noexcept {
  if (pose.rotation.size() < skeleton.joint.size()) return;
  const ArmRotations walks = walked_by(arm, pose);
  if (!std::exchange(motion.begun, true)) motion.shown = motion.walked = walks;
  const ArmRotations wanted = wanted_by(skeleton, arm, order, walks, pose);
  const double before = std::exchange(motion.ordered, order.seconds);
  const bool another = order.gesture != Gesture::None && order.seconds < before + seconds / 2;
  if (order.gesture != motion.gesture || another)
    change_to(arm, order.gesture, wanted, seconds, motion);
  motion.since += seconds;
  const bool changes = motion.since < longest_change;
  for (std::size_t i = 0; i < arm.count; ++i) {
    Quat& rotation = pose.rotation[arm.joint[i]];
    rotation = wanted[i];
    if (changes)
      rotation =
          glm::normalize(rotation_of(rest_of(motion.difference[i], motion.since)) * rotation);
    if (seconds > 0)
      motion.rate[i] = turn_between(motion.shown[i], rotation) / static_cast<float>(seconds);
  }
  motion.shown = walked_by(arm, pose);
  motion.walked = walks;
}

}  // namespace docent::motion
