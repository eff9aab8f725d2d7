#include "content/avatar/stance.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "content/content_error.h"

namespace docent::avatar {
namespace {

/// Heights of joints as shares of an adult's stature (Drillis and Contini 1966, in Winter 2009,
/// figure 4.1).
constexpr float hip_share = 0.530F, shoulder_share = 0.818F;
/// Height of the ball joint of the foot over the sole, as a share of stature: that of the walker of
/// 1.70 m (content/gait/gait_skeleton.h).
constexpr float ball_share = 0.0147F;

/// A bone to be aimed: the joint that turns, the joint it points at, and where to.
struct Aim {
  BodyPart joint, end;
  Vec3 target;
};

struct SideParts {
  BodyPart hip, knee, ankle, toe, toe_tip, shoulder, elbow, wrist, hand_tip;
};
constexpr std::array<SideParts, 2> side_parts{
    {{BodyPart::LeftHip, BodyPart::LeftKnee, BodyPart::LeftAnkle, BodyPart::LeftToe,
      BodyPart::LeftToeTip, BodyPart::LeftShoulder, BodyPart::LeftElbow, BodyPart::LeftWrist,
      BodyPart::LeftHandTip},
     {BodyPart::RightHip, BodyPart::RightKnee, BodyPart::RightAnkle, BodyPart::RightToe,
      BodyPart::RightToeTip, BodyPart::RightShoulder, BodyPart::RightElbow, BodyPart::RightWrist,
      BodyPart::RightHandTip}}};

std::size_t required(const Skeleton& skeleton, BodyPart part) {
  const JointIndex joint = skeleton[part];
  if (joint == JointIndex::None)
    throw content::ContentError(
        {}, 0, 0, "incomplete-skeleton",
        "the avatar needs a skeleton with hips, knees, ankles, toes, shoulders, "
        "elbows, wrists, a neck and a head",
        "name the joints as common BVH files do, or leave the clips' skeleton whole");
  return index_of(joint);
}

/// The shortest turn from one direction to another; nothing where they are opposite or empty.
Quat turn_between(Vec3 from, Vec3 to) {
  if (glm::dot(from, from) < 1e-12F) return Quat{1, 0, 0, 0};
  from = glm::normalize(from);
  to = glm::normalize(to);
  const float c = glm::dot(from, to);
  if (c < -0.9999F) return Quat{1, 0, 0, 0};
  const Vec3 axis = glm::cross(from, to);
  return glm::normalize(Quat{1 + c, axis.x, axis.y, axis.z});
}

Quat yaw_towards(Vec3 from, Vec3 to) {
  return turn_between({from.x, 0, from.z}, {to.x, 0, to.z});
}

std::vector<Vec3> identity_positions(const Skeleton& skeleton) {
  std::vector<Vec3> at(skeleton.joint.size());
  for (std::size_t j = 0; j < at.size(); ++j) {
    const Joint& joint = skeleton.joint[j];
    at[j] = joint.parent == JointIndex::None ? Vec3{} : at[index_of(joint.parent)] + joint.offset;
  }
  return at;
}

/// World rotations of the stance, by joint; those with no aim follow their parents.
std::vector<Quat> stance_rotations(const Skeleton& skeleton, const std::vector<Vec3>& at_rest) {
  std::vector<Quat> aimed(skeleton.joint.size(), Quat{0, 0, 0, 0});
  for (const Side side : {Side::Left, Side::Right}) {
    const SideParts& parts = side_parts[static_cast<std::size_t>(side)];
    const float x = sign_of(side);
    const std::array<Aim, 5> aims{{
        {parts.hip, parts.knee, {x * 0.02F, -1, 0.01F}},
        {parts.knee, parts.ankle, {x * 0.015F, -1, -0.03F}},
        {parts.shoulder, parts.elbow, {x * 0.21F, -1, -0.04F}},
        {parts.elbow, parts.wrist, {x * 0.15F, -1, 0.15F}},
        {parts.wrist, parts.hand_tip, {x * 0.04F, -1, 0.2F}},
    }};
    for (const Aim& aim : aims) {
      const JointIndex end = skeleton[aim.end];
      if (end == JointIndex::None) continue;
      const std::size_t joint = required(skeleton, aim.joint);
      aimed[joint] = turn_between(at_rest[index_of(end)] - at_rest[joint], aim.target);
    }
    const std::size_t ankle = required(skeleton, parts.ankle);
    const std::size_t toe = required(skeleton, parts.toe);
    const Vec3 outward{x * 0.1F, 0, 1};
    aimed[ankle] = yaw_towards(at_rest[toe] - at_rest[ankle], outward);
    const JointIndex tip = skeleton[parts.toe_tip];
    aimed[toe] = tip == JointIndex::None
                     ? aimed[ankle]
                     : yaw_towards(at_rest[index_of(tip)] - at_rest[toe], outward);
  }

  std::vector<Quat> world(skeleton.joint.size(), Quat{1, 0, 0, 0});
  for (std::size_t j = 0; j < world.size(); ++j) {
    const JointIndex parent = skeleton.joint[j].parent;
    if (aimed[j].w != 0)
      world[j] = aimed[j];
    else if (parent != JointIndex::None)
      world[j] = world[index_of(parent)];
  }
  return world;
}

LimbPoints limb_points(const Skeleton& skeleton, const std::vector<Vec3>& at, Side side) {
  const SideParts& parts = side_parts[static_cast<std::size_t>(side)];
  const auto place = [&](BodyPart part) { return at[required(skeleton, part)]; };
  LimbPoints limb{.hip = place(parts.hip),
                  .knee = place(parts.knee),
                  .ankle = place(parts.ankle),
                  .toe = place(parts.toe),
                  .foot_forward = {},
                  .shoulder = place(parts.shoulder),
                  .elbow = place(parts.elbow),
                  .wrist = place(parts.wrist),
                  .hand_axis = {}};
  const Vec3 foot = limb.toe - limb.ankle;
  limb.foot_forward = glm::normalize(Vec3{foot.x, 0, foot.z});
  const JointIndex tip = skeleton[parts.hand_tip];
  limb.hand_axis = glm::normalize(tip == JointIndex::None ? limb.wrist - limb.elbow
                                                          : at[index_of(tip)] - limb.wrist);
  return limb;
}

}  // namespace

Stance stand_at_ease(const Skeleton& skeleton) {
  const std::vector<Quat> turn = stance_rotations(skeleton, identity_positions(skeleton));
  std::vector<Vec3> at(skeleton.joint.size());
  for (std::size_t j = 0; j < at.size(); ++j) {
    const Joint& joint = skeleton.joint[j];
    if (joint.parent == JointIndex::None) continue;
    const std::size_t parent = index_of(joint.parent);
    at[j] = at[parent] + turn[parent] * joint.offset;
  }

  const auto both = [&](BodyPart left, BodyPart right) {
    return 0.5F * (at[required(skeleton, left)] + at[required(skeleton, right)]);
  };
  const Vec3 hips = both(BodyPart::LeftHip, BodyPart::RightHip);
  const Vec3 toes = both(BodyPart::LeftToe, BodyPart::RightToe);
  const Vec3 shoulders = both(BodyPart::LeftShoulder, BodyPart::RightShoulder);
  const float stature = 0.5F * ((hips.y - toes.y) / (hip_share - ball_share) +
                                (shoulders.y - toes.y) / (shoulder_share - ball_share));
  const Vec3 shift{-hips.x, ball_share * stature - toes.y, -hips.z};
  for (Vec3& place : at) place += shift;

  Stance stance{
      .world = {},
      .limb = {limb_points(skeleton, at, Side::Left), limb_points(skeleton, at, Side::Right)},
      .neck = at[required(skeleton, BodyPart::Neck)],
      .head = at[required(skeleton, BodyPart::Head)],
      .stature = stature};
  for (std::size_t j = 0; j < at.size(); ++j)
    stance.world.push_back(glm::translate(Mat4{1.0F}, at[j]) * glm::mat4_cast(turn[j]));
  return stance;
}

}  // namespace docent::avatar
