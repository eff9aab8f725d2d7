#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/motion/leg.h"
#include "runtime/motion/pose.h"

namespace docent::motion {
namespace {

constexpr double fade_seconds = 2.0;
constexpr double breath_seconds = 4.3;   // 14 breaths a minute, an adult at rest
constexpr float breath_angle = 0.012f;   // radians of the chest
constexpr float breath_rise = 0.0015f;   // metres of the hips
constexpr float sway_sideways = 0.014f;  // metres of the hips
constexpr float sway_forwards = 0.005f;

/// Two waves whose periods have no common multiple worth waiting for.
float wander(double seconds, double period, double phase) noexcept {
  const double turn = 2 * std::numbers::pi * seconds / period;
  return static_cast<float>(0.65 * std::sin(turn + phase) +
                            0.35 * std::sin(turn * std::numbers::phi + 2 * phase));
}

void nod(const Skeleton& skeleton, BodyPart part, Vec3 axis, float angle, PoseView& pose) noexcept {
  const JointIndex joint = skeleton[part];
  if (joint == JointIndex::None || index_of(joint) >= pose.rotation.size()) return;
  Quat& rotation = pose.rotation[index_of(joint)];
  rotation = glm::normalize(rotation * glm::angleAxis(angle, axis));
}

}  // namespace

void add_idle(const Skeleton& skeleton, double seconds, PoseView& pose) noexcept {
  if (!(seconds > 0) || pose.rotation.size() < skeleton.joint.size()) return;
  const std::optional<Legs> legs = find_legs(skeleton);
  if (!legs) return;
  std::array<Foot, 2> feet;
  for (const Side side : both_sides) feet[index_of(side)] = foot_of(skeleton, (*legs)[side], pose);

  const double t = std::min(seconds / fade_seconds, 1.0);
  const auto fade = static_cast<float>(t * t * (3 - 2 * t));
  const auto breath =
      static_cast<float>(0.5 - 0.5 * std::cos(2 * std::numbers::pi * seconds / breath_seconds));
  const Vec3 left = pose.rotation[0] * (*legs)[Side::Left].body_left;
  const Vec3 forwards = glm::cross(left, Vec3(0, 1, 0));
  const float aside = wander(seconds, 7.9, 0.0);
  // Over one foot the hips sink a little, and they never rise beyond what the legs reach.
  pose.root +=
      fade * (sway_sideways * aside * left + sway_forwards * wander(seconds, 5.7, 0.0) * forwards +
              Vec3(0, breath_rise * (breath - 1) - 0.004f * aside * aside, 0));
  nod(skeleton, BodyPart::Chest, {1, 0, 0}, -fade * breath_angle * breath, pose);
  nod(skeleton, BodyPart::Spine, {0, 0, 1}, fade * 0.012f * aside, pose);
  nod(skeleton, BodyPart::Head, {1, 0, 0}, fade * 0.008f * breath, pose);
  nod(skeleton, BodyPart::Head, {0, 1, 0}, fade * 0.03f * wander(seconds, 11.3, 0.0), pose);
  nod(skeleton, BodyPart::LeftShoulder, {0, 0, 1}, fade * 0.010f * breath, pose);
  nod(skeleton, BodyPart::RightShoulder, {0, 0, 1}, -fade * 0.010f * breath, pose);
  for (const Side side : both_sides)
    place_foot(skeleton, (*legs)[side], feet[index_of(side)], pose);
}

}  // namespace docent::motion
