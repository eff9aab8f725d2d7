#include "runtime/motion/touch.h"

#include <algorithm>
#include <cmath>

#include "runtime/motion/gesture.h"

namespace docent::motion {
namespace {

constexpr float off_surface = 0.13F;  ///< Metres: the palm comes from there, square to it.

Vec3 heading_vector(double heading) noexcept {
  return to_world({std::cos(heading), std::sin(heading)});
}

/// From rest to rest with the least jerk.
float reached_after(double share) noexcept {
  const double s = std::clamp(share, 0.0, 1.0);
  return static_cast<float>(s * s * s * (10 + s * (6 * s - 15)));
}

/// How far the hand is on its way from `ready` to the surface, 1 there.
float share_after(double seconds) noexcept {
  return reached_after(seconds < touch_ends
                           ? (seconds - longest_change) / (touch_begins - longest_change)
                           : (touch_seconds - seconds) / (touch_seconds - touch_ends));
}

}  // namespace

Stance moved_to(const Stance& stance, const Placement& body, double height) noexcept {
  const Quat turn =
      glm::angleAxis(static_cast<float>(body.heading - stance.body.heading), Vec3(0, 1, 0));
  Stance moved{.body = body, .height = height};
  for (std::size_t i = 0; i < moved.trunk.size(); ++i) {
    const JointPlace& trunk = stance.trunk[i];
    moved.trunk[i] = {to_world(body.position, height) +
                          turn * (trunk.place - to_world(stance.body.position, stance.height)),
                      turn * trunk.rotation};
  }
  moved.waist = to_world(body.position, height) +
                turn * (stance.waist - to_world(stance.body.position, stance.height));
  return moved;
}

namespace {

/// `left` of where it faces: a unit vector.
Quat bent(const TrunkBend& bend, Vec3 left) noexcept {
  const Quat turned = glm::angleAxis(bend.turn, Vec3(0, 1, 0));
  return glm::angleAxis(bend.lean, turned * left) * turned;
}

}  // namespace

Quat rotation_of(const TrunkBend& bend, double heading) noexcept {
  return bent(bend, glm::cross(Vec3(0, 1, 0), heading_vector(heading)));
}

Stance leaned(const Stance& stance, float lean) noexcept {
  const Quat turn = rotation_of({.lean = lean}, stance.body.heading);
  Stance leans = stance;
  for (JointPlace& trunk : leans.trunk)
    trunk = {stance.waist + turn * (trunk.place - stance.waist), turn * trunk.rotation};
  return leans;
}

void bend_trunk(const Skeleton& skeleton, const TrunkBend& bend, PoseView& pose) noexcept {
  const JointIndex spine = skeleton[BodyPart::Spine];
  if (spine == JointIndex::None || pose.rotation.size() < skeleton.joint.size() ||
      (bend.lean == 0 && bend.turn == 0))
    return;
  const Vec3 ahead = pose.rotation[0] * Vec3(0, 0, 1);
  const Vec3 left = glm::cross(Vec3(0, 1, 0), ahead);
  if (glm::length(left) < 1e-3F) return;
  Quat above(1, 0, 0, 0);
  for (JointIndex at = skeleton.joint[index_of(spine)].parent; at != JointIndex::None;
       at = skeleton.joint[index_of(at)].parent)
    above = pose.rotation[index_of(at)] * above;
  Quat& rotation = pose.rotation[index_of(spine)];
  rotation =
      glm::normalize(glm::inverse(above) * bent(bend, glm::normalize(left)) * above * rotation);
}

Grip grip_of(const Touch& touch) noexcept {
  return {.place = touch.palm, .fingers = touch.fingers, .thumb = touch.thumb};
}

Grip grip_after(const Touch& touch, double seconds) noexcept {
  const float s = share_after(seconds);
  // An arc that comes down square to the surface.
  const Vec3 above = touch.palm + off_surface * touch.normal;
  Grip grip = grip_of(touch);
  grip.place = glm::mix(glm::mix(touch.ready, above, s), glm::mix(above, touch.palm, s), s);
  return grip;
}

float lean_after(const Touch& touch, double seconds) noexcept {
  return touch.lean * share_after(seconds);
}

}  // namespace docent::motion
