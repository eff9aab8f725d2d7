#include "runtime/motion/arm.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <limits>
#include <numbers>

#include "runtime/motion/chance.h"
#include "runtime/motion/rotation.h"

namespace docent::motion {
namespace {

// All postures are worked out for a left arm, whose outside is +x: a right one is its mirror image.

Vec3 mirrored(Vec3 v, Side side) noexcept {
  return {sign_of(side) * v.x, v.y, v.z};
}
Quat mirrored(Quat q, Side side) noexcept {
  const float sign = sign_of(side);
  return {q.w, q.x, sign * q.y, sign * q.z};
}

constexpr auto pi = std::numbers::pi_v<float>;
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr Vec3 up{0, 1, 0}, forwards{0, 0, 1};
constexpr float longest_stretch = 0.965F;  ///< Of the arm: nobody points with a locked elbow.
constexpr float palm_share = 0.5F;   ///< Of the hand, from the wrist to the middle of the palm.
constexpr float finger_gap = 0.04F;  ///< Metres that the fingers stay off a target within reach.

std::optional<Arm> find_arm(const Skeleton& skeleton, Side side) {
  const bool left = side == Side::Left;
  const JointIndex clavicle = skeleton[left ? BodyPart::LeftClavicle : BodyPart::RightClavicle];
  const JointIndex shoulder = skeleton[left ? BodyPart::LeftShoulder : BodyPart::RightShoulder];
  const JointIndex elbow = skeleton[left ? BodyPart::LeftElbow : BodyPart::RightElbow];
  const JointIndex wrist = skeleton[left ? BodyPart::LeftWrist : BodyPart::RightWrist];
  const JointIndex tip = skeleton[left ? BodyPart::LeftHandTip : BodyPart::RightHandTip];
  if (shoulder == JointIndex::None || elbow == JointIndex::None || wrist == JointIndex::None)
    return std::nullopt;
  Arm arm;
  arm.side = side;
  const JointIndex first = clavicle == JointIndex::None ? shoulder : clavicle;
  for (JointIndex j = wrist;; j = skeleton.joint[index_of(j)].parent) {
    if (j == JointIndex::None || arm.count == Arm::most_joints) return std::nullopt;
    arm.joint[arm.count++] = static_cast<std::uint32_t>(index_of(j));
    if (j == first) break;
  }
  arm.trunk = skeleton.joint[index_of(first)].parent;
  if (arm.trunk == JointIndex::None) return std::nullopt;
  const auto end = arm.joint.begin() + static_cast<std::ptrdiff_t>(arm.count);
  std::reverse(arm.joint.begin(), end);
  const auto place_of = [&](JointIndex joint) {
    return static_cast<std::size_t>(std::find(arm.joint.begin(), end, index_of(joint)) -
                                    arm.joint.begin());
  };
  arm.shoulder = place_of(shoulder);
  arm.elbow = place_of(elbow);
  arm.wrist = place_of(wrist);
  if (clavicle != JointIndex::None) arm.clavicle = 0;
  if (arm.shoulder >= arm.elbow || arm.elbow >= arm.wrist) return std::nullopt;

  const auto bone = [&](std::size_t from, std::size_t to) {
    Vec3 sum{};
    for (std::size_t i = from + 1; i <= to; ++i) sum += skeleton.joint[arm.joint[i]].offset;
    return sum;
  };
  const Vec3 upper = bone(arm.shoulder, arm.elbow), fore = bone(arm.elbow, arm.wrist);
  Vec3 hand = 0.7F * fore;
  if (tip != JointIndex::None && skeleton.joint[index_of(tip)].parent == wrist &&
      glm::length(skeleton.joint[index_of(tip)].offset) > 0.02F)
    hand = skeleton.joint[index_of(tip)].offset;
  arm.upper = glm::length(upper);
  arm.fore = glm::length(fore);
  arm.hand = glm::length(hand);
  if (arm.upper < 0.02F || arm.fore < 0.02F) return std::nullopt;
  const Vec3 outwards = mirrored(Vec3(1, 0, 0), side);
  arm.rest = {shortest_arc(outwards, upper), shortest_arc(outwards, fore),
              shortest_arc(outwards, hand)};
  return arm;
}

/// A bone by where it points and where the thumb is, or would be were it the hand.
struct Bone {
  Vec3 along, thumb;
  Vec3 palm() const noexcept { return glm::cross(along, thumb); }  ///< Out of the palm.
};

Bone turned(Quat by, const Bone& bone) noexcept {
  return {by * bone.along, by * bone.thumb};
}

/// Upper arm, forearm and hand of a left arm, trunk's frame.
struct Bones {
  Bone upper, fore, hand;
};

Bone hanging_towards(Vec3 direction) noexcept {
  return {direction, shortest_arc(-up, direction) * forwards};
}

Bone upper_bone(const ArmPosture& posture) noexcept {
  const Bone straight = hanging_towards(posture.upper);
  return turned(glm::angleAxis(-posture.twist, straight.along), straight);
}

/// The forearm, before it is pronated.
Bone bent(const Bone& upper, float flexion) noexcept {
  return turned(glm::angleAxis(flexion, upper.palm()), upper);
}

Bone pronated(const Bone& fore, float angle) noexcept {
  return turned(glm::angleAxis(angle, fore.along), fore);
}

Bones bones_of(const ArmPosture& posture) noexcept {
  const Bone upper = upper_bone(posture);
  const Bone plain = bent(upper, posture.flexion);
  const Bone fore = pronated(plain, posture.pronation);
  const Quat wrist =
      rotation_of(posture.wrist_deviation * fore.palm() - posture.wrist_flexion * fore.thumb);
  // The radius turns about the ulna: half of the turn is seen half way down.
  return {upper, pronated(plain, posture.pronation / 2), turned(wrist, fore)};
}

/// The rotation, in the trunk's frame, that a bone's joint must have.
Quat rotation_of_bone(const Arm& arm, std::size_t which, const Bone& bone) noexcept {
  const Vec3 along = mirrored(bone.along, arm.side), thumb = mirrored(bone.thumb, arm.side);
  const Vec3 out = mirrored(Vec3(1, 0, 0), arm.side);
  const glm::mat3 from(out, forwards, glm::cross(out, forwards));
  const glm::mat3 to(along, thumb, glm::cross(along, thumb));
  return glm::normalize(glm::quat_cast(to * glm::transpose(from)) * glm::inverse(arm.rest[which]));
}

Quat collar_rotation(const ArmPosture& posture) noexcept {
  return glm::angleAxis(-posture.reach, up) * glm::angleAxis(posture.lift, forwards);
}

/// The shoulder joint of a left arm in the trunk's frame.
Vec3 shoulder_place(const Skeleton& skeleton, const Arm& arm, const ArmPosture& posture) noexcept {
  Vec3 place = mirrored(skeleton.joint[arm.joint[0]].offset, arm.side);
  Vec3 rest{};
  for (std::size_t i = 1; i <= arm.shoulder; ++i) rest += skeleton.joint[arm.joint[i]].offset;
  rest = mirrored(rest, arm.side);
  return place + (arm.clavicle ? collar_rotation(posture) * rest : rest);
}

/// What is left of `v` square to a unit vector, with unit length; `otherwise` where that is
/// nothing.
Vec3 square_to(Vec3 axis, Vec3 v, Vec3 otherwise) noexcept {
  const Vec3 rest = v - axis * glm::dot(axis, v);
  const float length = glm::length(rest);
  return length < 1e-3F ? otherwise : rest / length;
}

/// The angle about a unit axis that turns `from` into `to`, both square to it.
float angle_about(Vec3 axis, Vec3 from, Vec3 to) noexcept {
  return std::atan2(glm::dot(axis, glm::cross(from, to)), glm::dot(from, to));
}

/// A direction as an arm's joints allow it to be pointed in: azimuth from straight ahead, outwards
/// positive, and elevation.
Vec3 direction_in_reach(Vec3 direction) noexcept {
  constexpr float across = 0.7F, behind = 1.9F, lowest = -1.25F, highest = 0.95F;
  const float azimuth = std::atan2(direction.x, direction.z);
  const float elevation = std::asin(std::clamp(direction.y, -1.0F, 1.0F));
  // Straight behind is as far from the one end as from the other: nearest is what counts.
  const float a = azimuth < -2.2F ? behind : std::clamp(azimuth, -across, behind);
  const float e = std::clamp(elevation, lowest, highest);
  return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

/// How the collar bone helps: it rises with an arm above the horizontal and goes along forwards.
void help_with_collar(Vec3 direction, ArmPosture& posture) noexcept {
  const float raised = std::acos(std::clamp(-direction.y, -1.0F, 1.0F));  // from hanging
  posture.lift = std::clamp(0.28F * (raised - 1.0F), 0.0F, arm_limits::lift);
  posture.reach = 0.18F * std::max(0.0F, direction.z);
}

/// The sides of a triangle to the cosine of the angle between the first two.
float cosine_between(float a, float b, float opposite) noexcept {
  return std::clamp((a * a + b * b - opposite * opposite) / (2 * a * b), -1.0F, 1.0F);
}

/// Turns the hand's thumb as nearly as may be towards `thumb`, and the hand along `along`.
void aim_hand(const Bone& plain, Vec3 along, Vec3 thumb, ArmPosture& posture) noexcept {
  posture.pronation =
      std::clamp(angle_about(plain.along, plain.thumb, square_to(plain.along, thumb, plain.thumb)),
                 -arm_limits::pronation, arm_limits::pronation);
  const Bone fore = pronated(plain, posture.pronation);
  const Vec3 turn = rotation_vector(shortest_arc(fore.along, along));
  posture.wrist_deviation = glm::dot(turn, fore.palm());
  posture.wrist_flexion = -glm::dot(turn, fore.thumb);
}

/// Brings the wrist `wrist` metres from the shoulder in a direction; the elbow hangs, as far as the
/// shoulder's twist makes it, and is spread outwards by `flare` from there.
void bend(const Arm& arm, Vec3 direction, float wrist, float flare, ArmPosture& posture) noexcept {
  constexpr float most_twist = 0.75F;
  const float cosine = cosine_between(arm.upper, wrist, arm.fore);
  const float sine = std::sqrt(1 - cosine * cosine);
  const Vec3 behind = -hanging_towards(direction).thumb;
  const Vec3 below = square_to(direction, -up, behind);
  const float twist = std::clamp(angle_about(direction, behind, below), -most_twist, most_twist);
  const Vec3 elbow = glm::angleAxis(twist + flare, direction) * behind;
  posture.upper = direction * cosine + elbow * sine;
  const Vec3 hinge = glm::cross(elbow, direction);
  const Vec3 thumb = glm::cross(hinge, posture.upper);
  posture.twist = -angle_about(posture.upper, hanging_towards(posture.upper).thumb, thumb);
  posture.flexion = std::acos(-cosine_between(arm.upper, arm.fore, wrist));
}

/// An elbow has no room behind the body: the nearer the hand, or the farther across the body, the
/// more it goes out to the side.
float flare_of(Vec3 direction, float stretch) noexcept {
  constexpr float from = 0.85F, to = 0.4F, near = 1.2F, across = 1.1F;
  const float share = std::clamp((from - stretch) / (from - to), 0.0F, 1.0F);
  return near * share * share * (3 - 2 * share) * (1 - std::max(0.0F, direction.x)) +
         across * std::max(0.0F, -direction.x);
}

/// The middle of the palm of a left arm, trunk's frame.
Vec3 palm_place(const Skeleton& skeleton, const Arm& arm, const ArmPosture& posture) noexcept {
  const Bone upper = upper_bone(posture);
  return shoulder_place(skeleton, arm, posture) + arm.upper * upper.along +
         arm.fore * bent(upper, posture.flexion).along +
         palm_share * arm.hand * bones_of(posture).hand.along;
}

}  // namespace

Arms find_arms(const Skeleton& skeleton) {
  Arms arms;
  for (const Side side : both_sides) arms.arm[index_of(side)] = find_arm(skeleton, side);
  return arms;
}

ArmPosture within_limits(const ArmPosture& posture) noexcept {
  namespace most = arm_limits;
  ArmPosture p = posture;
  float raised = std::min(std::acos(std::clamp(-p.upper.y, -1.0F, 1.0F)), most::elevation);
  const float level = std::hypot(p.upper.x, p.upper.z);
  if (level > 1e-4F) {
    // An arm that hangs may swing anywhere a little; the further it is raised the less behind.
    constexpr float hangs = 0.35F, straight_behind = 2.4F;
    float azimuth = std::atan2(p.upper.x, p.upper.z);
    const bool is_behind = azimuth > most::outwards || azimuth < -straight_behind;
    const float too_far = azimuth > 0 ? azimuth - most::outwards : pi;
    if (is_behind && raised - most::extension < too_far)
      raised = std::min(raised, most::extension);
    else if (raised >= hangs)
      azimuth = std::clamp(azimuth, -most::inwards, most::outwards);
    const float sine = std::sin(raised);
    p.upper = {sine * std::sin(azimuth), -std::cos(raised), sine * std::cos(azimuth)};
  }
  p.twist = std::clamp(p.twist, -most::twist_in, most::twist_out);
  p.flexion = std::clamp(p.flexion, 0.0F, most::flexion);
  p.pronation = std::clamp(p.pronation, -most::pronation, most::pronation);
  p.wrist_flexion = std::clamp(p.wrist_flexion, -most::wrist_flexion, most::wrist_flexion);
  p.wrist_deviation = std::clamp(p.wrist_deviation, -most::ulnar, most::radial);
  p.lift = std::clamp(p.lift, 0.0F, most::lift);
  p.reach = std::clamp(p.reach, 0.0F, most::reach);
  return p;
}

ArmPosture pointing(const Skeleton& skeleton, const Arm& arm, const JointPlace& trunk,
                    Vec3 target) noexcept {
  const Vec3 aim = mirrored(glm::inverse(trunk.rotation) * (target - trunk.place), arm.side);
  ArmPosture posture;
  const auto line = [&] { return aim - shoulder_place(skeleton, arm, posture); };
  const auto unit = [](Vec3 v) { return glm::length(v) > 1e-3F ? glm::normalize(v) : forwards; };
  help_with_collar(direction_in_reach(unit(line())), posture);
  const Vec3 direction = direction_in_reach(unit(line()));

  const float longest = longest_stretch * (arm.upper + arm.fore);
  const float shortest = std::sqrt(arm.upper * arm.upper + arm.fore * arm.fore);  // a right angle
  const float wrist =
      std::clamp(glm::length(line()) - arm.hand - finger_gap, std::min(shortest, longest), longest);
  bend(arm, direction, wrist, 0, posture);
  posture = within_limits(posture);

  constexpr float palm_up = 0.4F;  // the thumb leans outwards by that
  const Vec3 upright = square_to(direction, up, forwards);
  aim_hand(bent(upper_bone(posture), posture.flexion), direction,
           glm::angleAxis(-palm_up, direction) * upright, posture);
  return within_limits(posture);
}

ArmPosture holding(const Skeleton& skeleton, const Arm& arm, const JointPlace& trunk,
                   const Grip& grip) noexcept {
  constexpr int tries = 8;  // the wrist's limits turn the hand, and the palm goes with it
  const Quat back = glm::inverse(trunk.rotation);
  const Vec3 palm = mirrored(back * (grip.place - trunk.place), arm.side);
  const Vec3 fingers = mirrored(back * grip.fingers, arm.side);
  const Vec3 thumb = mirrored(back * grip.thumb, arm.side);
  const float longest = 0.995F * (arm.upper + arm.fore);
  const float shortest = std::abs(arm.upper - arm.fore) + 0.12F;
  ArmPosture posture, best;
  float least = infinity;
  Vec3 wrist = palm - palm_share * arm.hand * fingers;
  for (int i = 0; i < tries && least > 5e-4F; ++i) {
    Vec3 line = wrist - shoulder_place(skeleton, arm, posture);
    if (i < 2 && glm::length(line) > 1e-3F) {
      help_with_collar(glm::normalize(line), posture);
      line = wrist - shoulder_place(skeleton, arm, posture);
    }
    if (glm::length(line) < 1e-3F) break;
    const Vec3 direction = glm::normalize(line);
    const float distance = std::clamp(glm::length(line), std::min(shortest, longest), longest);
    bend(arm, direction, distance, flare_of(direction, distance / longest), posture);
    posture = within_limits(posture);
    aim_hand(bent(upper_bone(posture), posture.flexion), fingers, thumb, posture);
    posture = within_limits(posture);
    const Vec3 off = palm - palm_place(skeleton, arm, posture);
    if (glm::length(off) < least) {
      least = glm::length(off);
      best = posture;
    }
    wrist += off;
  }
  return best;
}

Vec3 palm_of(const Skeleton& skeleton, const Arm& arm, const JointPlace& trunk,
             const ArmPosture& posture) noexcept {
  return trunk.place + trunk.rotation * mirrored(palm_place(skeleton, arm, posture), arm.side);
}

ArmPlaces places_of(const Skeleton& skeleton, const Arm& arm, const JointPlace& trunk,
                    const ArmPosture& posture) noexcept {
  const Bones bones = bones_of(posture);
  const auto turned_out = [&](Vec3 v) { return trunk.rotation * mirrored(v, arm.side); };
  ArmPlaces places;
  places.shoulder = trunk.place + turned_out(shoulder_place(skeleton, arm, posture));
  places.elbow = places.shoulder + turned_out(arm.upper * bones.upper.along);
  places.wrist = places.elbow + turned_out(arm.fore * bent(bones.upper, posture.flexion).along);
  places.palm = places.wrist + turned_out(palm_share * arm.hand * bones.hand.along);
  places.tip = places.wrist + turned_out(arm.hand * bones.hand.along);
  places.faces = turned_out(bones.hand.palm());
  return places;
}

Vec3 thumb_of(Side side, Vec3 fingers, Vec3 faces) noexcept {
  return sign_of(side) * glm::cross(faces, fingers);
}

ArmPosture waving(const Skeleton& skeleton, const Arm& arm, const JointPlace& trunk, Vec3 target,
                  double seconds) noexcept {
  constexpr float raised = 1.25F;              // of the upper arm, from hanging
  constexpr float least = 0.5F, most = 1.45F;  // its azimuth
  constexpr float bend = 1.95F;                // of the elbow
  constexpr double beats = 1.7;                // a second
  constexpr float widest_swing = 0.24F, widest_flick = 0.16F;
  constexpr double lag = 0.9;  // of the wrist behind the forearm, radians of the beat
  const Vec3 aim = mirrored(glm::inverse(trunk.rotation) * (target - trunk.place), arm.side);
  ArmPosture posture;
  const float azimuth = std::atan2(aim.x, aim.z);
  const float towards = azimuth < -2.2F ? most : std::clamp(azimuth, least, most);
  const float sine = std::sin(raised);
  posture.upper = {sine * std::sin(towards), -std::cos(raised), sine * std::cos(towards)};
  help_with_collar(posture.upper, posture);
  posture.lift = std::max(posture.lift, 0.1F);
  posture.flexion = bend;
  const Vec3 straight = hanging_towards(posture.upper).thumb;
  const Vec3 upright = square_to(posture.upper, up, straight);
  const auto grown = static_cast<float>(least_jerk(seconds / 0.6));
  const float swing = grown * widest_swing, flick = grown * widest_flick;
  const double beat = 2 * std::numbers::pi * beats * seconds;
  posture.twist = -angle_about(posture.upper, straight, upright) +
                  swing * static_cast<float>(std::sin(beat)) - widest_swing;
  posture = within_limits(posture);
  const Bone plain = bent(upper_bone(posture), posture.flexion);
  const Vec3 facing =
      square_to(plain.along, aim - shoulder_place(skeleton, arm, posture), forwards);
  aim_hand(plain, plain.along, glm::cross(facing, plain.along), posture);
  posture.wrist_flexion = -0.15F;
  posture.wrist_deviation = -flick * static_cast<float>(std::sin(beat - lag));
  return within_limits(posture);
}

ArmPosture telling(double seconds) noexcept {
  const auto beat = [&](double period, double change, std::uint64_t which) {
    return static_cast<float>(least_jerk(seconds / 0.8) * kept_for(seconds, period, change, which));
  };
  const float raised = 0.42F + 0.08F * beat(1.3, 0.5, 1), azimuth = 0.75F;
  const float sine = std::sin(raised);
  return within_limits(
      {.upper = {sine * std::sin(azimuth), -std::cos(raised), sine * std::cos(azimuth)},
       .twist = 0.05F + 0.22F * beat(1.1, 0.45, 2),
       .flexion = 1.45F + 0.2F * beat(0.9, 0.4, 3),
       .pronation = -0.55F + 0.25F * beat(1.4, 0.5, 4),
       .wrist_flexion = -0.2F + 0.2F * beat(0.8, 0.35, 5),
       .wrist_deviation = 0.1F * beat(1.2, 0.4, 6)});
}

ArmRotations rotations_of(const Arm& arm, const ArmPosture& posture) noexcept {
  ArmRotations local;
  local.fill(Quat(1, 0, 0, 0));
  Quat above(1, 0, 0, 0);
  if (arm.clavicle) above = local[0] = mirrored(collar_rotation(posture), arm.side);
  const Bones bones = bones_of(posture);
  const auto place = [&](std::size_t joint, std::size_t which, const Bone& bone) {
    const Quat world = rotation_of_bone(arm, which, bone);
    local[joint] = glm::normalize(glm::inverse(above) * world);
    above = world;
  };
  place(arm.shoulder, 0, bones.upper);
  place(arm.elbow, 1, bones.fore);
  place(arm.wrist, 2, bones.hand);
  return local;
}

}  // namespace docent::motion
