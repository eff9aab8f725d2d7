#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "content/avatar/stance.h"
#include "content/character/fit.h"

namespace docent::character {
namespace {

/// How much of VRM's drag is the air's: who walks steadily keeps their hair down but for that. The
/// rest is drag about the body, as where a spring of VRM has a "center".
constexpr float share_of_air = 0.25F;
constexpr float thickest_end = 0.5F;  // metres

/// The shortest turn from one direction to another.
Quat shortest_turn(Vec3 from, Vec3 to) {
  from = glm::normalize(from);
  to = glm::normalize(to);
  const float c = glm::dot(from, to);
  if (c < -0.9999F) return glm::angleAxis(3.14159265F, Vec3(0, 0, 1));
  const Vec3 axis = glm::cross(from, to);
  return glm::normalize(Quat{1 + c, axis.x, axis.y, axis.z});
}

/// Which part of the recorded body each human bone goes with, and what if the recording has none.
struct Slot {
  BodyPart part, otherwise;
};
Slot slot_of(HumanBone bone, const BoneMap& bones) {
  using enum HumanBone;
  switch (bone) {
    case Hips:
      return {BodyPart::Hips, BodyPart::Hips};
    case Spine:
      // A trunk of one bone bends where the chest does.
      return bones.has(Chest) || bones.has(UpperChest) ? Slot{BodyPart::Spine, BodyPart::Chest}
                                                       : Slot{BodyPart::Chest, BodyPart::Spine};
    case Chest:
    case UpperChest:
      return {BodyPart::Chest, BodyPart::Spine};
    case Neck:
      return {BodyPart::Neck, BodyPart::Head};
    case Head:
    case LeftEye:
    case RightEye:
    case Jaw:
      return {BodyPart::Head, BodyPart::Neck};
    case LeftUpperLeg:
      return {BodyPart::LeftHip, BodyPart::LeftHip};
    case LeftLowerLeg:
      return {BodyPart::LeftKnee, BodyPart::LeftKnee};
    case LeftFoot:
      return {BodyPart::LeftAnkle, BodyPart::LeftAnkle};
    case LeftToes:
      return {BodyPart::LeftToe, BodyPart::LeftAnkle};
    case RightUpperLeg:
      return {BodyPart::RightHip, BodyPart::RightHip};
    case RightLowerLeg:
      return {BodyPart::RightKnee, BodyPart::RightKnee};
    case RightFoot:
      return {BodyPart::RightAnkle, BodyPart::RightAnkle};
    case RightToes:
      return {BodyPart::RightToe, BodyPart::RightAnkle};
    case LeftShoulder:
      return {BodyPart::LeftClavicle, BodyPart::Chest};
    case LeftUpperArm:
      return {BodyPart::LeftShoulder, BodyPart::LeftShoulder};
    case LeftLowerArm:
      return {BodyPart::LeftElbow, BodyPart::LeftElbow};
    case LeftHand:
      return {BodyPart::LeftWrist, BodyPart::LeftWrist};
    case RightShoulder:
      return {BodyPart::RightClavicle, BodyPart::Chest};
    case RightUpperArm:
      return {BodyPart::RightShoulder, BodyPart::RightShoulder};
    case RightLowerArm:
      return {BodyPart::RightElbow, BodyPart::RightElbow};
    case RightHand:
      return {BodyPart::RightWrist, BodyPart::RightWrist};
    default:
      break;
  }
  const bool is_left = bone_names[index_of(bone)].starts_with("left");
  return is_left ? Slot{BodyPart::LeftWrist, BodyPart::LeftWrist}
                 : Slot{BodyPart::RightWrist, BodyPart::RightWrist};
}

std::size_t joint_of(const Skeleton& skeleton, Slot slot) {
  const JointIndex joint =
      skeleton[slot.part] != JointIndex::None ? skeleton[slot.part] : skeleton[slot.otherwise];
  return joint == JointIndex::None ? 0 : index_of(joint);
}

/// One limb bone: the part that turns, the part it points at; in the character, likewise.
struct LimbBone {
  BodyPart part, end;
  HumanBone bone, bone_end;
};
constexpr std::array limb_bones{
    LimbBone{BodyPart::LeftHip, BodyPart::LeftKnee, HumanBone::LeftUpperLeg,
             HumanBone::LeftLowerLeg},
    LimbBone{BodyPart::LeftKnee, BodyPart::LeftAnkle, HumanBone::LeftLowerLeg, HumanBone::LeftFoot},
    LimbBone{BodyPart::RightHip, BodyPart::RightKnee, HumanBone::RightUpperLeg,
             HumanBone::RightLowerLeg},
    LimbBone{BodyPart::RightKnee, BodyPart::RightAnkle, HumanBone::RightLowerLeg,
             HumanBone::RightFoot},
    LimbBone{BodyPart::LeftShoulder, BodyPart::LeftElbow, HumanBone::LeftUpperArm,
             HumanBone::LeftLowerArm},
    LimbBone{BodyPart::LeftElbow, BodyPart::LeftWrist, HumanBone::LeftLowerArm,
             HumanBone::LeftHand},
    LimbBone{BodyPart::RightShoulder, BodyPart::RightElbow, HumanBone::RightUpperArm,
             HumanBone::RightLowerArm},
    LimbBone{BodyPart::RightElbow, BodyPart::RightWrist, HumanBone::RightLowerArm,
             HumanBone::RightHand},
};

/// Where a hand points: to the fingers, or on as the forearm does.
Vec3 hand_direction(const Standing& s, bool is_left) {
  using enum HumanBone;
  const Vec3 hand = s.at_bind(is_left ? LeftHand : RightHand);
  Vec3 sum{0};
  for (const HumanBone finger : is_left ? std::array{LeftIndexProximal, LeftMiddleProximal,
                                                     LeftRingProximal, LeftLittleProximal}
                                        : std::array{RightIndexProximal, RightMiddleProximal,
                                                     RightRingProximal, RightLittleProximal})
    if (s.bones.has(finger)) sum += s.at_bind(finger) - hand;
  const Vec3 forearm = hand - s.at_bind(is_left ? LeftLowerArm : RightLowerArm);
  return glm::length(sum) > 0.05F * glm::length(forearm) ? sum : forearm;
}

/// For each joint the turn from the character as it was modelled into the joint's own frame, and
/// the character's place that lies on the joint.
struct Alignment {
  std::vector<Quat> turn;
  std::vector<Vec3> place;
  std::vector<glm::mat3> stretch;  ///< Along the bone, before the turn.
};

glm::mat3 stretch_along(Vec3 way, float by) {
  const Vec3 d = glm::normalize(way);
  return glm::mat3{1} + (by - 1) * glm::outerProduct(d, d);
}

Alignment align(const Character& character, const Measures& m, const Fit& fit) {
  const Skeleton& skeleton = fit.skeleton;
  const avatar::Stance stance = avatar::stand_at_ease(skeleton);
  const std::size_t joints = skeleton.joint.size();
  Alignment alignment;
  alignment.turn.assign(joints, Quat{1, 0, 0, 0});
  alignment.stretch.assign(joints, glm::mat3{1});
  std::vector<std::optional<Vec3>> place(joints);
  const auto own_turn = [&](std::size_t j) { return glm::quat_cast(glm::mat3(stance.world[j])); };

  const auto take = [&](BodyPart part, HumanBone bone, Quat in_stance) {
    const std::size_t j = index_of(skeleton[part]);
    alignment.turn[j] = glm::inverse(own_turn(j)) * in_stance;
    place[j] = m.place(character.standing.at_bind(bone));
  };
  const Standing& s = character.standing;
  const auto stance_way = [&](BodyPart from, BodyPart to) {
    return Vec3(stance.world[index_of(skeleton[to])][3] -
                stance.world[index_of(skeleton[from])][3]);
  };
  for (const LimbBone& limb : limb_bones) {
    const Vec3 way = s.at_bind(limb.bone_end) - s.at_bind(limb.bone);
    take(limb.part, limb.bone, shortest_turn(way, stance_way(limb.part, limb.end)));
    const bool is_thigh = limb.part == BodyPart::LeftHip || limb.part == BodyPart::RightHip;
    const bool is_shin = limb.part == BodyPart::LeftKnee || limb.part == BodyPart::RightKnee;
    if (is_thigh || is_shin)
      alignment.stretch[index_of(skeleton[limb.part])] =
          stretch_along(way, is_thigh ? fit.thigh : fit.shin);
  }
  for (const bool is_left : {true, false}) {
    using enum HumanBone;
    const BodyPart wrist = is_left ? BodyPart::LeftWrist : BodyPart::RightWrist;
    const BodyPart tip = is_left ? BodyPart::LeftHandTip : BodyPart::RightHandTip;
    const BodyPart elbow = is_left ? BodyPart::LeftElbow : BodyPart::RightElbow;
    const bool has_tip = skeleton[tip] != JointIndex::None;
    take(wrist, is_left ? LeftHand : RightHand,
         shortest_turn(hand_direction(s, is_left),
                       has_tip ? stance_way(wrist, tip) : stance_way(elbow, wrist)));
    // A foot keeps its sole flat and turns about the vertical only.
    const HumanBone foot = is_left ? LeftFoot : RightFoot, toes = is_left ? LeftToes : RightToes;
    const BodyPart ankle = is_left ? BodyPart::LeftAnkle : BodyPart::RightAnkle;
    const BodyPart toe = is_left ? BodyPart::LeftToe : BodyPart::RightToe;
    Vec3 modelled = s.bones.has(toes) ? s.at_bind(toes) - s.at_bind(foot) : Vec3(0, 0, 1);
    modelled.y = 0;
    if (glm::length(modelled) < 1e-5F || modelled.z < 0) modelled = Vec3(0, 0, 1);
    Vec3 standing = stance_way(ankle, toe);
    standing.y = 0;
    const Quat yaw = shortest_turn(modelled, standing);
    take(ankle, foot, yaw);
    const std::size_t t = index_of(skeleton[toe]);
    alignment.turn[t] = glm::inverse(own_turn(t)) * yaw;
    place[t] = s.bones.has(toes) ? m.place(s.at_bind(toes))
                                 : m.place(s.at_bind(foot)) + m.foot * glm::normalize(modelled);
  }
  // The rest of the body stands in the stance as it does at rest: joints lie where they were put.
  const float sole = stance.world[index_of(skeleton[BodyPart::LeftHip])][3].y - m.hip;
  for (std::size_t j = 0; j < joints; ++j)
    alignment.place.push_back(place[j].value_or(Vec3(stance.world[j][3]) - Vec3(0, sole, 0)));
  return alignment;
}

struct JointWeights {
  std::array<std::uint8_t, 4> joint{}, weight{};
};

/// `joint` has one for each bone of the body, then one for each that swings.
JointWeights weights_of(const BoneShares& shares, const std::vector<std::uint8_t>& joint) {
  std::vector<std::pair<float, std::uint8_t>> parts;
  for (std::size_t k = 0; k < 4; ++k) {
    if (!(shares.share[k] > 0)) continue;
    const std::uint8_t j = joint[shares.bone[k]];
    const auto same = std::ranges::find(parts, j, &std::pair<float, std::uint8_t>::second);
    if (same == parts.end())
      parts.emplace_back(shares.share[k], j);
    else
      same->first += shares.share[k];
  }
  if (parts.empty()) parts.emplace_back(1.0F, joint[0]);
  std::ranges::sort(parts, std::greater<>());
  JointWeights out;
  int left = 255;
  for (std::size_t k = parts.size(); k-- > 1;) {
    const int weight = std::min(left, static_cast<int>(std::lround(255 * parts[k].first)));
    out.joint[k] = weight > 0 ? parts[k].second : parts[0].second;
    out.weight[k] = static_cast<std::uint8_t>(weight);
    left -= weight;
  }
  out.joint[0] = parts[0].second;
  out.weight[0] = static_cast<std::uint8_t>(left);
  return out;
}

/// Rounding may have left it a hair too strong.
Vec3 limited(Vec3 gravity) {
  const float strength = glm::length(gravity);
  return strength < most_cloth_gravity ? gravity : 0.999F * most_cloth_gravity / strength * gravity;
}

/// A spring that a step of the clock could not follow is made weaker, and its weight with it, so
/// that it hangs as it would. One that is stronger than numbers go is as stiff as can be.
ClothNode node_of(const SpringBone& bone, const Measures& m, std::uint8_t joint) {
  const float length = glm::distance(bone.root, bone.end);
  // As strong as VRM's constant pull for what swings on a string so long.
  const float stiffness = std::min(bone.pull / length, std::numeric_limits<float>::max());
  const float gravity = m.scale * glm::length(bone.gravity);
  const float weaker = std::min({1.0F, most_cloth_pull / std::max(stiffness, 1.0F),
                                 most_cloth_gravity / std::max(gravity, 1.0F)});
  return {.kind = ClothKind::Bone,
          .joint = {joint, 0, 0, 0},
          .weight = {255, 0, 0, 0},
          .place = m.place(bone.end),
          .outward = Vec3{0, 0, 1},
          .above = bone.above < 0 ? ClothNode::none : static_cast<std::uint8_t>(bone.above),
          .radius = std::min(m.scale * bone.radius, thickest_end),
          .stiffness = std::min(weaker * stiffness, most_cloth_pull),
          .damping = std::min((1 - share_of_air) * bone.drag, most_cloth_damping),
          .drag = std::min(share_of_air * bone.drag, most_cloth_damping),
          .root = m.place(bone.root),
          .gravity = limited(weaker * m.scale * bone.gravity)};
}

/// Binds what swings: the springs that have room, and the limbs that they are kept out of.
Cloth cloth_of(const Springs& springs, const Measures& m, const std::vector<std::uint8_t>& joint) {
  Cloth cloth;
  const std::vector<std::uint32_t> ball = busiest_balls(springs, most_cloth_colliders);
  for (const std::uint32_t c : ball) {
    const SpringBall& it = springs.ball[c];
    const float radius = std::min(m.scale * it.radius, most_cloth_radius);
    cloth.collider.push_back({.joint = joint[index_of(it.body)],
                              .from = m.place(it.from),
                              .to = m.place(it.to),
                              .from_radius = radius,
                              .to_radius = radius});
  }
  for (const SpringBone& bone : springs.bone) {
    ClothNode node = node_of(bone, m, joint[index_of(bone.body)]);
    for (const std::uint32_t c : bone.colliders)
      if (const auto at = std::ranges::find(ball, c) - ball.begin();
          at < static_cast<std::ptrdiff_t>(ball.size()))
        node.keeps_out |= 1U << static_cast<unsigned>(at);
    cloth.node.push_back(node);
  }
  return cloth;
}

}  // namespace

SkinnedMesh bind_body(const Character& character, const Measures& m, const Fit& fit) {
  std::vector<std::uint8_t> joint(bone_count);
  for (std::size_t b = 0; b < bone_count; ++b)
    joint[b] = static_cast<std::uint8_t>(
        joint_of(fit.skeleton, slot_of(static_cast<HumanBone>(b), character.standing.bones)));
  const std::size_t joints = fit.skeleton.joint.size();
  std::vector<std::int32_t> became;
  const Springs springs =
      with_at_most(std::min(most_bones_of_a_guide, most_joints - std::min(joints, most_joints)),
                   character.swinging, became);

  SkinnedMesh mesh;
  mesh.cloth = cloth_of(springs, m, joint);
  for (std::size_t s = 0; s < became.size(); ++s)
    joint.push_back(became[s] >= 0
                        ? static_cast<std::uint8_t>(joints + static_cast<std::size_t>(became[s]))
                        : joint[index_of(character.swinging.bone[s].body)]);
  for (const SurfaceVertex& v : character.body.surface.vertices) {
    const JointWeights weights = weights_of(v.shares, joint);
    mesh.vertices.push_back({.position = m.place(v.position),
                             .normal = v.normal,
                             .joint = weights.joint,
                             .weight = weights.weight,
                             .material = Material::Own});
  }
  mesh.indices = character.body.surface.indices;
  mesh.figure_end = {static_cast<std::uint32_t>(mesh.indices.size())};
  mesh.colour = character.body.colour;
  const Alignment alignment = align(character, m, fit);
  for (std::size_t j = 0; j < fit.skeleton.joint.size(); ++j)
    mesh.inverse_bind.push_back(glm::mat4_cast(alignment.turn[j]) * Mat4(alignment.stretch[j]) *
                                glm::translate(Mat4{1}, -alignment.place[j]));
  return mesh;
}

}  // namespace docent::character
