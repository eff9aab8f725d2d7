#include "runtime/motion/idle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "runtime/motion/chance.h"
#include "runtime/motion/replant.h"

namespace docent::motion {
namespace {

constexpr double fade_seconds = 2.0;
constexpr double breath_seconds = 4.3;    // 14 breaths a minute, an adult at rest
constexpr float breath_angle = 0.014f;    // radians of the chest
constexpr float breath_rise = 0.0015f;    // metres of the hips
constexpr double stance_seconds = 8.5;    // for about so long people stand on one leg rather...
constexpr double shift_seconds = 1.7;     // ... before they shift their weight
constexpr float shift_sideways = 0.042f;  // metres of the hips
constexpr float shift_roll = 0.08f;       // radians that the hips drop on the free leg's side
constexpr float sway_sideways = 0.005f, sway_forwards = 0.005f;
constexpr float slack = 0.004f;         // metres that hips sink from a stand at attention
constexpr float longest_leg = 0.9985f;  // of its length, when it bears the body

/// Two waves whose periods have no common multiple worth waiting for.
float wander(double seconds, double period, double phase) noexcept {
  const double turn = 2 * std::numbers::pi * std::fmod(seconds / period, 1e6);
  return static_cast<float>(0.65 * std::sin(turn + phase) +
                            0.35 * std::sin(turn * std::numbers::phi + 2 * phase));
}

void turn(const Skeleton& skeleton, BodyPart part, Vec3 axis, float angle,
          PoseView& pose) noexcept {
  const JointIndex joint = skeleton[part];
  if (joint == JointIndex::None || index_of(joint) >= pose.rotation.size()) return;
  Quat& rotation = pose.rotation[index_of(joint)];
  rotation = glm::normalize(rotation * glm::angleAxis(angle, axis));
}

/// A number that is kept for a while, then changes; for each of a body's habits another.
float habit(double seconds, double period, double change, std::uint64_t who,
            std::uint64_t which) noexcept {
  return static_cast<float>(kept_for(seconds, period, change, who * 31 + which));
}

/// Elbows that bend a little more or less, forearms that roll: hands that do not quite rest.
void move_hands(const Arms& arms, double seconds, float fade, std::uint64_t who,
                PoseView& pose) noexcept {
  for (const Side side : both_sides) {
    if (!arms[side]) continue;
    const Arm& arm = *arms[side];
    const std::uint64_t which = 10 * (index_of(side) + 1);
    const Vec3 out(sign_of(side), 0, 0);
    const auto bend = [&](std::size_t place, std::size_t bone, Vec3 axis, float angle) {
      Quat& rotation = pose.rotation[arm.joint[place]];
      rotation = glm::normalize(rotation * glm::angleAxis(fade * angle, arm.rest[bone] * axis));
    };
    const Vec3 hinge = glm::cross(out, Vec3(0, 0, 1));
    bend(arm.shoulder, 0, hinge, 0.06F * habit(seconds, 10.0, 1.6, who, which + 4));
    const float bent = 0.5F + 0.5F * habit(seconds, 11.0, 1.3, who, which);
    bend(arm.elbow, 1, hinge,
         0.16F * bent + 0.02F * wander(seconds, 6.1, index_of(side) == 0 ? 0.4 : 2.9));
    bend(arm.elbow, 1, out, sign_of(side) * 0.2F * habit(seconds, 14.0, 1.1, who, which + 1));
    bend(arm.wrist, 2, hinge, 0.10F * habit(seconds, 9.0, 0.8, who, which + 2));
    bend(arm.wrist, 2, Vec3(0, 0, 1), 0.10F * habit(seconds, 7.0, 0.7, who, which + 3));
  }
}

}  // namespace

Limbs find_limbs(const Skeleton& skeleton) {
  return {find_legs(skeleton), find_arms(skeleton)};
}

void add_idle(const Skeleton& skeleton, const Limbs& limbs, const Standing& standing,
              PoseView& pose) noexcept {
  const auto& [seconds, weight, who] = standing;
  if (!(seconds > 0) || !(weight > 0) || pose.rotation.size() < skeleton.joint.size() ||
      !limbs.legs)
    return;
  const Legs& legs = *limbs.legs;
  std::array<Foot, 2> feet;
  for (const Side side : both_sides) feet[index_of(side)] = foot_of(skeleton, legs[side], pose);

  const auto fade = static_cast<float>(least_jerk(seconds / fade_seconds) * least_jerk(weight));
  const double breathing = breath_seconds * (1 + 0.1 * (chance(who, 0) - 0.5));
  const auto breath = static_cast<float>(
      0.5 - 0.5 * std::cos(2 * std::numbers::pi * std::fmod(seconds, breathing) / breathing));
  const Vec3 left = pose.rotation[0] * legs[Side::Left].body_left;
  const Vec3 forwards = glm::cross(left, Vec3(0, 1, 0));
  // Never quite in the middle for long: one stands on one leg.
  const float side = habit(seconds, stance_seconds, shift_seconds, who, 1);
  const float borne = side * (1.5F - 0.5F * side * side);
  const float aside = shift_sideways * borne + sway_sideways * wander(seconds, 7.9, 0.0);
  pose.root += fade * (aside * left + sway_forwards * wander(seconds, 5.7, 0.3) * forwards +
                       Vec3(0, breath_rise * (breath - 1) - slack, 0));
  const float roll = fade * shift_roll * borne;
  const float yaw = fade * 0.03F * habit(seconds, stance_seconds, shift_seconds, who, 2);
  pose.rotation[0] = glm::normalize(glm::angleAxis(roll, forwards) *
                                    glm::angleAxis(yaw, Vec3(0, 1, 0)) * pose.rotation[0]);
  turn(skeleton, BodyPart::Spine, {0, 0, 1}, -0.8F * roll, pose);
  turn(skeleton, BodyPart::Chest, {0, 0, 1}, -0.5F * roll, pose);
  turn(skeleton, BodyPart::Spine, {0, 1, 0}, -yaw, pose);
  turn(skeleton, BodyPart::Chest, {0, 1, 0}, fade * 0.07F * habit(seconds, 7.0, 1.5, who, 4), pose);
  turn(skeleton, BodyPart::Chest, {1, 0, 0}, -fade * breath_angle * breath, pose);
  turn(skeleton, BodyPart::Head, {1, 0, 0}, fade * 0.008f * breath, pose);
  turn(skeleton, BodyPart::Head, {0, 0, 1},
       fade * 0.03f * habit(seconds, 6.0, 0.9, who, 3) + 0.3F * roll, pose);
  turn(skeleton, BodyPart::LeftShoulder, {0, 0, 1}, fade * 0.010f * breath, pose);
  turn(skeleton, BodyPart::RightShoulder, {0, 0, 1}, -fade * 0.010f * breath, pose);
  move_hands(limbs.arms, seconds, fade, who, pose);

  float drop = 0;
  for (const Side s : both_sides)
    drop = std::max(
        drop, drop_into_reach(hip_of(skeleton, legs[s], pose), ankle_of(legs[s], feet[index_of(s)]),
                              longest_leg * legs[s].length));
  pose.root.y -= fade * drop;
  for (const Side s : both_sides) place_foot(skeleton, legs[s], feet[index_of(s)], pose);
}

}  // namespace docent::motion
