#include "content/character/fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "content/content_error.h"

namespace docent::character {
namespace {

constexpr float tallest = 2.1F, smallest = 0.5F, usual = 1.75F;
/// Where a ball joint rests above the ground at least, metres of a body with an adult's legs.
/// By how much of the leg's length a knee may be higher or lower than the recorded one: beyond it
/// both legs of a stride would not reach the ground at once, so the bones are stretched.
constexpr float knee_freedom = 0.03F;
constexpr float lowest_toe = 0.004F;

struct SideBones {
  HumanBone upper_leg, lower_leg, foot, toes, upper_arm, lower_arm, hand, middle, index;
};
constexpr std::array<SideBones, 2> side_bones{
    {{HumanBone::LeftUpperLeg, HumanBone::LeftLowerLeg, HumanBone::LeftFoot, HumanBone::LeftToes,
      HumanBone::LeftUpperArm, HumanBone::LeftLowerArm, HumanBone::LeftHand,
      HumanBone::LeftMiddleProximal, HumanBone::LeftIndexProximal},
     {HumanBone::RightUpperLeg, HumanBone::RightLowerLeg, HumanBone::RightFoot,
      HumanBone::RightToes, HumanBone::RightUpperArm, HumanBone::RightLowerArm,
      HumanBone::RightHand, HumanBone::RightMiddleProximal, HumanBone::RightIndexProximal}}};

/// The share that a vertex has in some bones.
template <typename Is>
float share_of(const Character& character, const SurfaceVertex& vertex, Is is) {
  float share = 0;
  for (std::size_t k = 0; k < 4; ++k)
    if (is(body_bone(character.swinging, vertex.shares.bone[k]))) share += vertex.shares.share[k];
  return share;
}
bool is_of_foot(HumanBone bone) {
  using enum HumanBone;
  return bone == LeftFoot || bone == LeftToes || bone == RightFoot || bone == RightToes;
}

float mean_length(const Standing& s, HumanBone SideBones::* from, HumanBone SideBones::* to) {
  float sum = 0;
  for (const SideBones& side : side_bones)
    sum += glm::distance(s.at_bind(side.*from), s.at_bind(side.*to));
  return 0.5F * sum;
}

/// The same place of both sides, as if it were on the left.
Vec3 mean_place(const Standing& s, HumanBone SideBones::* bone, float middle) {
  const Vec3 left = s.at_bind(side_bones[0].*bone), right = s.at_bind(side_bones[1].*bone);
  return {0.5F * (left.x - right.x) + middle, 0.5F * (left.y + right.y), 0.5F * (left.z + right.z)};
}

/// Height of the soles: the lowest of the feet's skin, where there is any below the ankles.
float sole_of(const Character& character, float ankle, float leg) {
  float lowest = ankle;
  for (const SurfaceVertex& v : character.body.surface.vertices)
    if (share_of(character, v, is_of_foot) > 0.5F) lowest = std::min(lowest, v.position.y);
  const float usual_ankle = 0.09F * leg;
  return lowest < ankle - 0.01F * leg && lowest > ankle - 0.6F * leg ? lowest : ankle - usual_ankle;
}

/// From the ankle to the ball: to the toes' joint, or a share of the foot's skin before the ankle.
float foot_of(const Character& character, float leg) {
  const Standing& s = character.standing;
  float longest = 0, joints = 0;
  for (const SideBones& side : side_bones) {
    const Vec3 ankle = s.at_bind(side.foot);
    if (s.bones.has(side.toes)) {
      const Vec3 toe = s.at_bind(side.toes) - ankle;
      joints += 0.5F * std::hypot(toe.x, toe.z);
    }
    for (const SurfaceVertex& v : character.body.surface.vertices)
      if (share_of(character, v, is_of_foot) > 0.5F &&
          std::abs(v.position.x - ankle.x) < 0.3F * leg)
        longest = std::max(longest, v.position.z - ankle.z);
  }
  if (joints > 0.05F * leg && s.bones.has(HumanBone::LeftToes) && s.bones.has(HumanBone::RightToes))
    return joints;
  return longest > 0.05F * leg ? 0.68F * longest : 0.16F * leg;
}

}  // namespace

Measures measure(const Character& character) {
  const Standing& s = character.standing;
  Measures m;
  const Vec3 left = s.at_bind(HumanBone::LeftUpperLeg), right = s.at_bind(HumanBone::RightUpperLeg);
  const Vec3 hips = 0.5F * (left + right);
  const float thigh = mean_length(s, &SideBones::upper_leg, &SideBones::lower_leg);
  const float shin = mean_length(s, &SideBones::lower_leg, &SideBones::foot);
  const Vec3 ankle = mean_place(s, &SideBones::foot, 0);
  const float sole = sole_of(character, ankle.y, thigh + shin);
  m.origin = {hips.x, sole, hips.z};
  float top = s.at_bind(HumanBone::Head).y;
  float crown = top;
  for (const SurfaceVertex& v : character.body.surface.vertices) {
    top = std::max(top, v.position.y);
    if (share_of(character, v, [](HumanBone b) { return b == HumanBone::Head; }) > 0.5F)
      crown = std::max(crown, v.position.y);
  }
  const float height = top - sole;
  m.scale = height > tallest || height < smallest ? usual / std::max(height, 1e-6F) : 1;
  m.height = m.scale * height;
  m.hip = m.scale * (hips.y - sole);
  m.hip_half = m.scale * 0.5F * (left.x - right.x);
  m.thigh = m.scale * thigh;
  m.shin = m.scale * shin;
  m.ankle = m.scale * (ankle.y - sole);
  m.foot = m.scale * foot_of(character, thigh + shin);
  m.shoulder = m.place(mean_place(s, &SideBones::upper_arm, hips.x));
  m.head = m.place(s.at_bind(HumanBone::Head));
  m.head.x = 0;
  m.neck = s.bones.has(HumanBone::Neck)
               ? m.place(s.at_bind(HumanBone::Neck))
               : glm::mix(Vec3(0, m.shoulder.y, m.shoulder.z), m.head, 0.35F);
  m.neck.x = 0;
  m.upper_arm = m.scale * mean_length(s, &SideBones::upper_arm, &SideBones::lower_arm);
  m.forearm = m.scale * mean_length(s, &SideBones::lower_arm, &SideBones::hand);
  m.hand = 0.65F * m.forearm;
  m.crown = m.scale * (crown - sole);
  return m;
}

namespace {

/// Places of joints when nothing turns.
std::vector<Vec3> rest_places(const Skeleton& skeleton) {
  std::vector<Vec3> at(skeleton.joint.size());
  for (std::size_t j = 0; j < at.size(); ++j) {
    const Joint& joint = skeleton.joint[j];
    if (joint.parent != JointIndex::None) at[j] = at[index_of(joint.parent)] + joint.offset;
  }
  return at;
}

std::size_t required(const Skeleton& skeleton, BodyPart part) {
  if (skeleton[part] == JointIndex::None)
    throw content::ContentError({}, 0, 0, "incomplete-skeleton",
                                "a character needs clips whose skeleton has hips, knees, ankles, "
                                "toes, shoulders, elbows, wrists, a neck and a head",
                                "name the joints as common BVH files do");
  return index_of(skeleton[part]);
}

struct SideParts {
  BodyPart hip, knee, ankle, toe, toe_tip, clavicle, shoulder, elbow, wrist, hand_tip;
};
constexpr std::array<SideParts, 2> side_parts{
    {{BodyPart::LeftHip, BodyPart::LeftKnee, BodyPart::LeftAnkle, BodyPart::LeftToe,
      BodyPart::LeftToeTip, BodyPart::LeftClavicle, BodyPart::LeftShoulder, BodyPart::LeftElbow,
      BodyPart::LeftWrist, BodyPart::LeftHandTip},
     {BodyPart::RightHip, BodyPart::RightKnee, BodyPart::RightAnkle, BodyPart::RightToe,
      BodyPart::RightToeTip, BodyPart::RightClavicle, BodyPart::RightShoulder, BodyPart::RightElbow,
      BodyPart::RightWrist, BodyPart::RightHandTip}}};

Vec3 direction(Vec3 from, Vec3 to, Vec3 otherwise) {
  const Vec3 way = to - from;
  const float length = glm::length(way);
  return length > 1e-5F ? way / length : otherwise;
}

/// New places for the joints of a recording's skeleton: some are given, what lies between them
/// keeps its share of the way, and what hangs on them is scaled.
class Places {
 public:
  Places(const Skeleton& recorded, float scale)
      : recorded_{recorded}, old_{rest_places(recorded)}, new_(old_.size()), scale_{scale} {}

  void put(std::size_t joint, Vec3 place) { new_[joint] = place; }
  Vec3 old_place(std::size_t joint) const { return old_[joint]; }
  Vec3 new_place(std::size_t joint) const { return *new_[joint]; }

  Skeleton skeleton() const {
    Skeleton fitted = recorded_;
    const std::vector<Vec3> at = all();
    for (std::size_t j = 0; j < at.size(); ++j)
      if (const JointIndex parent = recorded_.joint[j].parent; parent != JointIndex::None)
        fitted.joint[j].offset = at[j] - at[index_of(parent)];
    return fitted;
  }

 private:
  std::vector<Vec3> all() const {
    std::vector<Vec3> at(old_.size());
    for (std::size_t j = 0; j < at.size(); ++j) {
      if (new_[j]) {
        at[j] = *new_[j];
        continue;
      }
      const JointIndex parent = recorded_.joint[j].parent;
      if (parent == JointIndex::None) continue;
      const std::size_t above = index_of(parent);
      const std::optional<std::size_t> below = given_below(j);
      float share = scale_;
      if (below && glm::distance(old_[*below], old_[above]) > 1e-5F)
        share = glm::distance(*new_[*below], at[above]) / glm::distance(old_[*below], old_[above]);
      at[j] = at[above] + share * (old_[j] - old_[above]);
    }
    return at;
  }
  /// The first joint below with a given place.
  std::optional<std::size_t> given_below(std::size_t joint) const {
    for (std::size_t j = joint + 1; j < old_.size(); ++j) {
      if (!new_[j]) continue;
      for (JointIndex up = recorded_.joint[j].parent; up != JointIndex::None;
           up = recorded_.joint[index_of(up)].parent)
        if (index_of(up) == joint) return j;
    }
    return {};
  }

  const Skeleton& recorded_;
  std::vector<Vec3> old_;
  std::vector<std::optional<Vec3>> new_;
  float scale_;
};

}  // namespace

Fit fit_skeleton(const Skeleton& recorded, const Measures& m, float toe_rest) {
  const auto joint = [&](BodyPart part) { return required(recorded, part); };
  const std::vector<Vec3> old = rest_places(recorded);
  const auto length = [&](BodyPart a, BodyPart b) {
    return glm::distance(old[joint(a)], old[joint(b)]);
  };
  Fit fit;
  fit.legs = (m.thigh + m.shin) / (length(BodyPart::LeftHip, BodyPart::LeftKnee) +
                                   length(BodyPart::LeftKnee, BodyPart::LeftAnkle));
  // The foot turns about its ball as the recorded one does, or hips would rise and sink with it.
  const Vec3 old_step = old[joint(BodyPart::LeftToe)] - old[joint(BodyPart::LeftAnkle)];
  const float drop = std::min(-fit.legs * old_step.y, m.ankle - lowest_toe * fit.legs);
  fit.toe_rest = m.ankle - drop;
  const float old_share = length(BodyPart::LeftHip, BodyPart::LeftKnee) /
                          (length(BodyPart::LeftHip, BodyPart::LeftKnee) +
                           length(BodyPart::LeftKnee, BodyPart::LeftAnkle));
  const float leg = m.thigh + m.shin;
  const float thigh =
      leg * std::clamp(m.thigh / leg, old_share - knee_freedom, old_share + knee_freedom);
  fit.thigh = thigh / m.thigh;
  fit.shin = (leg - thigh) / m.shin;
  fit.pelvis = std::clamp(
      0.5F * fit.legs * length(BodyPart::LeftHip, BodyPart::RightHip) / std::max(m.hip_half, 1e-3F),
      0.1F, 1.2F);
  fit.ankle = m.ankle;
  fit.recorded_ankle =
      old[joint(BodyPart::LeftAnkle)].y - old[joint(BodyPart::LeftToe)].y + toe_rest;

  // Places of the trunk are the character's own, from the middle of its hip joints.
  Places places(recorded, fit.legs);
  const Vec3 old_hips = 0.5F * (old[joint(BodyPart::LeftHip)] + old[joint(BodyPart::RightHip)]);
  const Vec3 hips{0, m.hip, 0};
  const auto put = [&](BodyPart part, Vec3 place) { places.put(joint(part), place); };
  places.put(0, hips + fit.legs * (old[0] - old_hips));
  const Vec3 old_neck = old[joint(BodyPart::Neck)] - old_hips;
  const Vec3 neck = m.neck - hips;
  const float trunk = neck.y / std::max(old_neck.y, 1e-3F);
  for (const BodyPart part : {BodyPart::Spine, BodyPart::Chest}) {
    if (recorded[part] == JointIndex::None || index_of(recorded[part]) == 0) continue;
    const Vec3 off = old[joint(part)] - old_hips;
    const float share = off.y / std::max(old_neck.y, 1e-3F);
    put(part, hips + share * neck + Vec3(0, 0, trunk * (off.z - share * old_neck.z)));
  }
  put(BodyPart::Neck, m.neck);
  put(BodyPart::Head, m.head);
  if (recorded[BodyPart::HeadTop] != JointIndex::None)
    put(BodyPart::HeadTop, {m.head.x, std::max(m.crown, m.head.y + 0.02F), m.head.z});

  const float across = m.shoulder.x / std::max(old[joint(BodyPart::LeftShoulder)].x, 1e-3F);
  for (const SideParts& side : side_parts) {
    const float x = &side == &side_parts[0] ? 1.0F : -1.0F;
    const auto aim = [&](BodyPart from, BodyPart to, float reach) {
      const Vec3 way = direction(old[joint(from)], old[joint(to)], Vec3(0, -1, 0));
      put(to, places.new_place(joint(from)) + reach * way);
    };
    put(side.hip, {x * m.hip_half, m.hip, 0});
    aim(side.hip, side.knee, fit.thigh * m.thigh);
    aim(side.knee, side.ankle, fit.shin * m.shin);
    const Vec3 old_foot = old[joint(side.toe)] - old[joint(side.ankle)];
    const Vec3 forward = direction(Vec3{0}, Vec3(old_foot.x, 0, old_foot.z), Vec3(0, 0, 1));
    put(side.toe, places.new_place(joint(side.ankle)) +
                      fit.legs * std::hypot(old_foot.x, old_foot.z) * forward - Vec3(0, drop, 0));
    if (recorded[side.clavicle] != JointIndex::None) {
      const Vec3 off = old[joint(side.clavicle)] - old[joint(BodyPart::Neck)];
      put(side.clavicle, m.neck + Vec3(across * off.x, trunk * off.y, trunk * off.z));
    }
    put(side.shoulder, {x * m.shoulder.x, m.shoulder.y, m.shoulder.z});
    aim(side.shoulder, side.elbow, m.upper_arm);
    aim(side.elbow, side.wrist, m.forearm);
    if (recorded[side.hand_tip] != JointIndex::None) aim(side.wrist, side.hand_tip, m.hand);
  }
  fit.skeleton = places.skeleton();
  return fit;
}

}  // namespace docent::character
