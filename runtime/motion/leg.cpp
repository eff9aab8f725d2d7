#include "runtime/motion/leg.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

#include "runtime/motion/rotation.h"

namespace docent::motion {
namespace {

using Vec2f = glm::vec2;  // of a cosine and a sine

std::optional<Leg> find_leg(const Skeleton& skeleton, BodyPart hip, BodyPart knee, BodyPart ankle,
                            BodyPart toe, BodyPart tip) {
  for (const BodyPart part : {hip, knee, ankle, toe})
    if (skeleton[part] == JointIndex::None) return std::nullopt;
  Leg leg;
  std::size_t count = 0;
  for (JointIndex j = skeleton[toe]; j != JointIndex::None;
       j = skeleton.joint[index_of(j)].parent) {
    if (count == Leg::max_joints) return std::nullopt;
    leg.joint[count++] = static_cast<std::uint32_t>(index_of(j));
  }
  std::reverse(leg.joint.begin(), leg.joint.begin() + static_cast<std::ptrdiff_t>(count));
  const auto place_of = [&](BodyPart part) {
    const auto end = leg.joint.begin() + static_cast<std::ptrdiff_t>(count);
    return static_cast<std::size_t>(
        std::find(leg.joint.begin(), end, static_cast<std::uint32_t>(index_of(skeleton[part]))) -
        leg.joint.begin());
  };
  leg.hip = place_of(hip);
  leg.knee = place_of(knee);
  leg.ankle = place_of(ankle);
  leg.toe = count - 1;
  if (leg.hip >= leg.knee || leg.knee >= leg.ankle || leg.ankle + 1 != leg.toe) return std::nullopt;
  leg.ankle_to_toe = skeleton.joint[leg.joint[leg.toe]].offset;
  if (skeleton[tip] != JointIndex::None && skeleton[tip] != skeleton[toe])
    leg.tip = skeleton.joint[index_of(skeleton[tip])].offset;
  for (std::size_t i = leg.hip + 1; i <= leg.ankle; ++i)
    leg.length += glm::length(skeleton.joint[leg.joint[i]].offset);
  return leg;
}

/// Where a hip joint is in the root's frame when nothing turns.
Vec3 rest_hip(const Skeleton& skeleton, const Leg& leg) {
  Vec3 place{};
  for (std::size_t i = 1; i <= leg.hip; ++i) place += skeleton.joint[leg.joint[i]].offset;
  return place;
}

/// The cosine of the angle opposite to side `c` of a triangle.
float opposite_cosine(float a, float b, float c) noexcept {
  return std::clamp((a * a + b * b - c * c) / (2 * a * b), -1.0f, 1.0f);
}

/// A turn about an axis by an angle in (-pi, pi), of which sine and cosine are known.
Quat turn_about(Vec3 axis, float sine, float cosine) noexcept {
  const float half_cosine = std::sqrt(std::max(0.5f + 0.5f * cosine, 1e-6f));
  return {half_cosine, (0.5f * sine / half_cosine) * axis};
}

}  // namespace

std::optional<Legs> find_legs(const Skeleton& skeleton) {
  const auto left = find_leg(skeleton, BodyPart::LeftHip, BodyPart::LeftKnee, BodyPart::LeftAnkle,
                             BodyPart::LeftToe, BodyPart::LeftToeTip);
  const auto right = find_leg(skeleton, BodyPart::RightHip, BodyPart::RightKnee,
                              BodyPart::RightAnkle, BodyPart::RightToe, BodyPart::RightToeTip);
  if (!left || !right) return std::nullopt;
  Legs legs{{*left, *right}};
  const Vec3 across = rest_hip(skeleton, *left) - rest_hip(skeleton, *right);
  if (glm::length(across) < 1e-4f) return std::nullopt;
  for (Leg& leg : legs.leg) leg.body_left = glm::normalize(across);
  return legs;
}

namespace {

/// As far down as the leg's joint `last`.
LegPose pose_as_far_as(std::size_t last, const Skeleton& skeleton, const Leg& leg,
                       const PoseView& pose) noexcept {
  LegPose out;
  out.position[0] = pose.root;
  out.rotation[0] = pose.rotation[leg.joint[0]];
  for (std::size_t i = 1; i <= last; ++i) {
    const std::uint32_t j = leg.joint[i];
    out.position[i] = out.position[i - 1] + out.rotation[i - 1] * skeleton.joint[j].offset;
    out.rotation[i] = out.rotation[i - 1] * pose.rotation[j];
  }
  return out;
}

}  // namespace

LegPose leg_pose(const Skeleton& skeleton, const Leg& leg, const PoseView& pose) noexcept {
  return pose_as_far_as(leg.toe, skeleton, leg, pose);
}
LegPose shank_pose(const Skeleton& skeleton, const Leg& leg, const PoseView& pose) noexcept {
  return pose_as_far_as(leg.ankle, skeleton, leg, pose);
}

Vec3 hip_of(const Skeleton& skeleton, const Leg& leg, const PoseView& pose) noexcept {
  Vec3 place = pose.root;
  Quat rotation = pose.rotation[leg.joint[0]];
  for (std::size_t i = 1; i <= leg.hip; ++i) {
    place += rotation * skeleton.joint[leg.joint[i]].offset;
    if (i < leg.hip) rotation = rotation * pose.rotation[leg.joint[i]];
  }
  return place;
}

Foot foot_of(const Skeleton& skeleton, const Leg& leg, const PoseView& pose) noexcept {
  const LegPose at = leg_pose(skeleton, leg, pose);
  return {at.position[leg.toe], at.rotation[leg.ankle]};
}

Vec3 ankle_of(const Leg& leg, const Foot& foot) noexcept {
  return foot.toe - foot.rotation * leg.ankle_to_toe;
}

void place_foot(const Skeleton& skeleton, const Leg& leg, const Foot& foot,
                PoseView& pose) noexcept {
  const LegPose at = shank_pose(skeleton, leg, pose);
  const Vec3 hip = at.position[leg.hip], knee = at.position[leg.knee],
             ankle = at.position[leg.ankle], target = ankle_of(leg, foot);
  const float thigh = glm::length(knee - hip), shin = glm::length(ankle - knee);
  if (thigh < 1e-4f || shin < 1e-4f) return;
  const float reach = std::clamp(glm::length(target - hip), std::abs(thigh - shin) + 1e-3f,
                                 (thigh + shin) * 0.9999f);

  // The hinge points to the thigh's left. It follows the knee's own plane where the knee is bent
  // the right way; a straight leg has no plane, and one that a blend has bent backwards the wrong
  // one.
  const Vec3 left = at.rotation[leg.hip] * leg.body_left;
  const Vec3 plane = glm::cross(knee - hip, ankle - knee);
  const float backwards = std::min(0.0f, glm::dot(plane, left));
  const Vec3 hinge = glm::normalize(plane - backwards * left + left * (0.02f * thigh * shin));
  // How far the knee is bent, and how far it shall be: what is between is turned, all by sines and
  // cosines, which spares three arcs.
  const Vec2f bent = glm::normalize(
      Vec2f(glm::dot(knee - hip, ankle - knee), glm::dot(plane, hinge)) + Vec2f(1e-12f, 0));
  const float inner = opposite_cosine(thigh, shin, reach);
  const Vec2f wanted(-inner, std::sqrt(1 - inner * inner));
  const Quat flex = glm::normalize(turn_about(hinge, wanted.y * bent.x - wanted.x * bent.y,
                                              wanted.x * bent.x + wanted.y * bent.y));
  const Vec3 flexed_ankle = knee + flex * (ankle - knee);
  const Quat swing = shortest_arc(flexed_ankle - hip, target - hip);

  const auto parent_rotation = [&](std::size_t place) {
    return place == 0 ? Quat(1, 0, 0, 0) : at.rotation[place - 1];
  };
  const Quat hip_rotation = swing * at.rotation[leg.hip];
  const Quat knee_parent = swing * parent_rotation(leg.knee);
  const Quat knee_rotation = swing * flex * at.rotation[leg.knee];
  const Quat ankle_parent = swing * flex * parent_rotation(leg.ankle);
  pose.rotation[leg.joint[leg.hip]] =
      glm::normalize(glm::inverse(parent_rotation(leg.hip)) * hip_rotation);
  pose.rotation[leg.joint[leg.knee]] = glm::normalize(glm::inverse(knee_parent) * knee_rotation);
  pose.rotation[leg.joint[leg.ankle]] = glm::normalize(glm::inverse(ankle_parent) * foot.rotation);
}

double facing(const Skeleton& skeleton, const Legs& legs, const PoseView& pose) noexcept {
  const Leg& l = legs[Side::Left];
  const Leg& r = legs[Side::Right];
  const Vec3 across = hip_of(skeleton, l, pose) - hip_of(skeleton, r, pose);
  const Vec2 left = to_floor(across);
  return std::atan2(-left.x, left.y);
}

}  // namespace docent::motion
