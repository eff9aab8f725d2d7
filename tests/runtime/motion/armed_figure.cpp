#include "tests/runtime/motion/armed_figure.h"

#include <cmath>

#include "tests/runtime/motion/hand_made_graph.h"

namespace docent::test {
namespace {

float angle_between(Vec3 a, Vec3 b) {
  return std::acos(std::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0F, 1.0F));
}

void add_arm(float x, const std::array<BodyPart, 5>& parts, Skeleton& s) {
  JointIndex parent = s[BodyPart::Chest];
  const auto add = [&](Vec3 offset) {
    s.joint.push_back({"arm", parent, offset});
    s.has_rotation.push_back(true);
    parent = static_cast<JointIndex>(s.joint.size() - 1);
    return parent;
  };
  const auto name = [&](std::size_t part, Vec3 offset) {
    s.part[static_cast<std::size_t>(parts[part])] = add(offset);
  };
  name(0, {0.03F * x, 0.13F, 0.01F});
  name(1, {0.14F * x, 0.01F, -0.02F});
  name(2, {0.29F * x, -0.01F, -0.01F});
  add({0.12F * x, 0, 0});  // a bone that twists
  name(3, {0.13F * x, 0.005F, 0});
  name(4, {0.17F * x, -0.01F, 0.01F});
}

}  // namespace

Skeleton stretched_figure() {
  Skeleton s = stick_figure();
  using enum BodyPart;
  // The stick's own arms stay as nameless bones.
  add_arm(1, {LeftClavicle, LeftShoulder, LeftElbow, LeftWrist, LeftHandTip}, s);
  add_arm(-1, {RightClavicle, RightShoulder, RightElbow, RightWrist, RightHandTip}, s);
  return s;
}

ArmedFigure::ArmedFigure(Skeleton shape)
    : skeleton(std::move(shape)),
      arms(motion::find_arms(skeleton)),
      rotation(skeleton.joint.size(), Quat(1, 0, 0, 0)) {
  rotation[0] = glm::angleAxis(2.1F, Vec3(0, 1, 0));
  rotation[index_of(skeleton[BodyPart::Chest])] =
      glm::angleAxis(0.1F, glm::normalize(Vec3(1, 0.6F, 0.2F)));
}

motion::JointPlace ArmedFigure::trunk(Side side) {
  return motion::place_of(skeleton, arms[side]->trunk, pose());
}

std::vector<Vec3> ArmedFigure::hold(Side side, const motion::ArmPosture& posture) {
  const motion::Arm& arm = *arms[side];
  const motion::ArmRotations held = motion::rotations_of(arm, posture);
  for (std::size_t i = 0; i < arm.count; ++i) rotation[arm.joint[i]] = held[i];
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < arm.count; ++i)
    places.push_back(
        motion::place_of(skeleton, static_cast<JointIndex>(arm.joint[i]), pose()).place);
  const motion::JointPlace wrist =
      motion::place_of(skeleton, static_cast<JointIndex>(arm.joint[arm.wrist]), pose());
  const Vec3 outwards(sign_of(side), 0, 0);
  places.push_back(wrist.place + wrist.rotation * (arm.rest[2] * outwards * arm.hand));
  return places;
}

MeasuredArm measured(const std::vector<Vec3>& joints, const motion::Arm& arm,
                     const motion::JointPlace& trunk) {
  const Vec3 upper = joints[arm.elbow] - joints[arm.shoulder];
  const Vec3 fore = joints[arm.wrist] - joints[arm.elbow];
  const Vec3 hand = joints.back() - joints[arm.wrist];
  const Vec3 seen = glm::inverse(trunk.rotation) * upper;
  return {.elevation = angle_between(seen, Vec3(0, -1, 0)),
          .azimuth = std::atan2(sign_of(arm.side) * seen.x, seen.z),
          .elbow = angle_between(upper, fore),
          .wrist = angle_between(fore, hand)};
}

}  // namespace docent::test
