#include "content/import/motion/body.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "content/content_error.h"
#include "content/import/motion/bvh.h"
#include "tests/content/import/motion/sample_body.h"

namespace docent::test {
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
}  // namespace docent::test
