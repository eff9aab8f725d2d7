#include "content/import/motion/body.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include <glm/gtc/matrix_transform.hpp>

#include "content/content_error.h"
#include "content/import/motion/bvh.h"
#include "tests/content/import/motion/sample_body.h"

namespace docent::test::body_test {
namespace {

using Names = std::map<std::string, std::string>;

/// The sample body under other names; a joint without an entry keeps its own.
std::vector<SampleJoint> renamed(const Names& names) {
  std::vector<SampleJoint> body = sample_body();
  for (SampleJoint& joint : body)
    if (const auto other = names.find(joint.name); other != names.end()) joint.name = other->second;
  return body;
}

Skeleton skeleton_of(const std::vector<SampleJoint>& body) {
  return import::parse_bvh(bvh_text(body, {standing_frame(body)}), "body.bvh", 1.0).skeleton;
}

void expect_same_parts(const Skeleton& skeleton, const Skeleton& expected) {
  for (std::size_t p = 0; p < expected.part.size(); ++p)
    EXPECT_EQ(skeleton.part[p], expected.part[p]) << "part " << p;
}

TEST(BodyParts, AreFoundByCmuNames) {
  const Skeleton skeleton = skeleton_of(sample_body());

  const auto named = [&](BodyPart part) { return skeleton.joint[index_of(skeleton[part])].name; };
  EXPECT_EQ(named(BodyPart::Hips), "Hips");
  EXPECT_EQ(named(BodyPart::LeftHip), "LeftUpLeg");
  EXPECT_EQ(named(BodyPart::LeftKnee), "LeftLeg");
  EXPECT_EQ(named(BodyPart::LeftAnkle), "LeftFoot");
  EXPECT_EQ(named(BodyPart::RightToe), "RightToeBase");
  EXPECT_EQ(named(BodyPart::RightToeTip), "RightToeBase end");
  EXPECT_EQ(named(BodyPart::LeftClavicle), "LeftShoulder");
  EXPECT_EQ(named(BodyPart::LeftShoulder), "LeftArm");
  EXPECT_EQ(named(BodyPart::RightElbow), "RightForeArm");
  EXPECT_EQ(named(BodyPart::RightWrist), "RightHand");
  EXPECT_EQ(named(BodyPart::RightHandTip), "RightHand end");
  EXPECT_EQ(named(BodyPart::Spine), "Spine");
  EXPECT_EQ(named(BodyPart::Chest), "Spine1");
  EXPECT_EQ(named(BodyPart::Neck), "Neck");
  EXPECT_EQ(named(BodyPart::Head), "Head");
  EXPECT_EQ(named(BodyPart::HeadTop), "Head end");
}

TEST(BodyParts, AreTheSameUnderOtherNames) {
  const Skeleton expected = skeleton_of(sample_body());
  Names mixamo, sides_behind, acclaim, joints;
  for (const SampleJoint& joint : sample_body()) mixamo[joint.name] = "mixamorig:" + joint.name;
  for (const std::string side : {"Left", "Right"}) {
    const std::string tail = "_" + side.substr(0, 1);
    const std::string letter = side == "Left" ? "l" : "r";
    const std::vector<std::pair<std::string, std::vector<std::string>>> limbs{
        // CMU's name: with the side behind, in ASF, and as anatomy calls the joint
        {"UpLeg", {"UpperLeg", "femur", "Hip"}},
        {"Leg", {"LowerLeg", "tibia", "Knee"}},
        {"Foot", {"Foot", "foot", "Ankle"}},
        {"ToeBase", {"Toes", "toes", "Toe"}},
        {"Shoulder", {"Shoulder", "clavicle", "Collar"}},
        {"Arm", {"UpperArm", "humerus", "Shoulder"}},
        {"ForeArm", {"LowerArm", "radius", "Elbow"}},
        {"Hand", {"Hand", "wrist", "Wrist"}}};
    for (const auto& [cmu, others] : limbs) {
      sides_behind[side + cmu] = others[0] + tail;
      acclaim[side + cmu] = letter + others[1];
      joints[side + cmu] = side + others[2];
    }
  }
  for (const Names& names : {mixamo, sides_behind, acclaim, joints})
    expect_same_parts(skeleton_of(renamed(names)), expected);
}

TEST(BodyParts, AreFoundByShapeWhereNamesSayNothing) {
  Names numbers;
  int number = 0;
  for (const SampleJoint& joint : sample_body())
    if (joint.parent >= 0) numbers[joint.name] = "bone" + std::to_string(++number);
  SampleFrame turned = standing_frame(sample_body());
  turned.zyx[0] = {0, 130, 0};  // whichever way it faces
  const auto body = renamed(numbers);

  const Skeleton skeleton = import::parse_bvh(bvh_text(body, {turned}), "body.bvh", 1.0).skeleton;

  Skeleton expected = skeleton_of(sample_body());
  using enum BodyPart;
  for (const BodyPart part : {LeftHip, LeftKnee, LeftAnkle, LeftToe, LeftToeTip, RightHip,
                              RightKnee, RightAnkle, RightToe, LeftShoulder, LeftElbow, LeftWrist,
                              RightShoulder, RightElbow, RightWrist, Head, HeadTop, Chest})
    EXPECT_EQ(skeleton[part], expected[part]) << static_cast<int>(part);
}

/// Some rigs' hips have their own y along a thigh, or to the front.
TEST(BodyParts, AreFoundByShapeHoweverTheHipsOwnAxesLie) {
  Names numbers;
  int number = 0;
  for (const SampleJoint& joint : sample_body())
    if (joint.parent >= 0) numbers[joint.name] = "bone" + std::to_string(++number);
  const Skeleton expected = skeleton_of(sample_body());
  for (const glm::dvec3 angles : {glm::dvec3{0, 0, 90}, {90, 0, 0}, {0, 70, -90}, {-90, 200, 0}}) {
    // What the hips' turn does to the body at rest is undone in its bones.
    auto body = renamed(numbers);
    SampleFrame frame = standing_frame(body);
    frame.zyx[0] = {angles.x, angles.y, angles.z};
    glm::dmat4 turn(1);
    turn = glm::rotate(turn, glm::radians(angles.x), {0, 0, 1});
    turn = glm::rotate(turn, glm::radians(angles.y), {0, 1, 0});
    turn = glm::rotate(turn, glm::radians(angles.z), {1, 0, 0});
    for (SampleJoint& joint : body)
      if (joint.parent >= 0)
        joint.offset = glm::dvec3(glm::inverse(turn) * glm::dvec4(joint.offset, 0));
    const Skeleton skeleton = import::parse_bvh(bvh_text(body, {frame}), "body.bvh", 1.0).skeleton;
    expect_same_parts(skeleton, expected);
  }
}

Names sides_swapped() {
  Names swapped;
  for (const SampleJoint& joint : sample_body())
    for (const auto& [side, other] : {std::pair{"Left", "Right"}, std::pair{"Right", "Left"}})
      if (joint.name.starts_with(side))
        swapped[joint.name] = other + joint.name.substr(std::string(side).size());
  return swapped;
}

TEST(BodyParts, DoNotBelieveNamesThatHaveTheFeetPointBackwards) {
  const auto body = renamed(sides_swapped());
  const import::RecordedMotion recorded =
      import::parse_bvh(bvh_text(body, {standing_frame(body)}), "body.bvh", 1.0);
  expect_same_parts(recorded.skeleton, skeleton_of(sample_body()));
  ASSERT_EQ(recorded.notes.size(), 1U);
  EXPECT_EQ(recorded.notes[0].code, "swapped-sides");
}

/// Crossed, turned out or pointed like a dancer's, feet do not say which side is which.
TEST(BodyParts, BelieveNamesWhereTheFeetLieOddly) {
  const std::vector<SampleJoint> body = sample_body();
  const auto joint_named = [&](std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(body, name, &SampleJoint::name) -
                                    body.begin());
  };
  for (const double out : {-100.0, -80.0, 80.0, 100.0}) {
    SampleFrame frame = standing_frame(body);
    frame.zyx[joint_named("LeftFoot")] = {0, out, 0};
    frame.zyx[joint_named("RightFoot")] = {0, -out, 0};
    const import::RecordedMotion recorded =
        import::parse_bvh(bvh_text(body, {frame}), "body.bvh", 1.0);
    expect_same_parts(recorded.skeleton, skeleton_of(body));
  }
}

TEST(BodyParts, LeaveOutWhatABodyDoesNotHave) {
  std::vector<SampleJoint> legs_only;
  for (const SampleJoint& joint : sample_body())
    if (legs_only.size() < 11) legs_only.push_back(joint);

  const Skeleton skeleton = skeleton_of(legs_only);

  EXPECT_EQ(index_of(skeleton[BodyPart::RightAnkle]), 8U);
  EXPECT_EQ(skeleton[BodyPart::LeftWrist], JointIndex::None);
}

TEST(LegLength, IsFromHipToAnkle) {
  EXPECT_NEAR(import::leg_length(skeleton_of(sample_body())), 0.82, 1e-6);
}

}  // namespace
}  // namespace docent::test::body_test
