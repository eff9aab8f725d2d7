#include "content/gait/gait_skeleton.h"

namespace docent::gait {
namespace {

struct Row {
  WalkerJoint joint, parent;
  BodyPart part;
  const char* name;  ///< Empty for end sites.
  double x, y, z;
};

/// Offsets from the parent, metres, of the walker of 1.70 m: x to the left, y up, z forward. Where
/// they come from is in the header.
constexpr std::array<Row, static_cast<std::size_t>(WalkerJoint::Count)> rows{{
    {WalkerJoint::Hips, WalkerJoint::Hips, BodyPart::Hips, "hips", 0, 0, 0},
    {WalkerJoint::Spine, WalkerJoint::Hips, BodyPart::Spine, "spine", 0, 0.085, -0.012},
    {WalkerJoint::Chest, WalkerJoint::Spine, BodyPart::Chest, "chest", 0, 0.155, -0.006},
    {WalkerJoint::Neck, WalkerJoint::Chest, BodyPart::Neck, "neck", 0, 0.215, -0.010},
    {WalkerJoint::Head, WalkerJoint::Neck, BodyPart::Head, "head", 0, 0.120, 0.014},
    {WalkerJoint::HeadTop, WalkerJoint::Head, BodyPart::HeadTop, "", 0, 0.163, 0.008},
    {WalkerJoint::LeftCollar, WalkerJoint::Chest, BodyPart::LeftClavicle, "left_collar", 0.02,
     0.175, 0.0},
    {WalkerJoint::LeftShoulder, WalkerJoint::LeftCollar, BodyPart::LeftShoulder, "left_shoulder",
     0.152, 0.012, -0.016},
    {WalkerJoint::LeftElbow, WalkerJoint::LeftShoulder, BodyPart::LeftElbow, "left_elbow", 0,
     -0.186 * walker::stature, 0},
    {WalkerJoint::LeftWrist, WalkerJoint::LeftElbow, BodyPart::LeftWrist, "left_wrist", 0,
     -0.146 * walker::stature, 0},
    {WalkerJoint::LeftHandTip, WalkerJoint::LeftWrist, BodyPart::LeftHandTip, "", 0, -0.165, 0},
    {WalkerJoint::RightCollar, WalkerJoint::Chest, BodyPart::RightClavicle, "right_collar", -0.02,
     0.175, 0.0},
    {WalkerJoint::RightShoulder, WalkerJoint::RightCollar, BodyPart::RightShoulder,
     "right_shoulder", -0.152, 0.012, -0.016},
    {WalkerJoint::RightElbow, WalkerJoint::RightShoulder, BodyPart::RightElbow, "right_elbow", 0,
     -0.186 * walker::stature, 0},
    {WalkerJoint::RightWrist, WalkerJoint::RightElbow, BodyPart::RightWrist, "right_wrist", 0,
     -0.146 * walker::stature, 0},
    {WalkerJoint::RightHandTip, WalkerJoint::RightWrist, BodyPart::RightHandTip, "", 0, -0.165, 0},
    {WalkerJoint::LeftHip, WalkerJoint::Hips, BodyPart::LeftHip, "left_hip", walker::hip_half,
     -walker::hip_drop, 0},
    {WalkerJoint::LeftKnee, WalkerJoint::LeftHip, BodyPart::LeftKnee, "left_knee", 0,
     -walker::thigh, 0},
    {WalkerJoint::LeftAnkle, WalkerJoint::LeftKnee, BodyPart::LeftAnkle, "left_ankle", 0,
     -walker::shin, 0},
    {WalkerJoint::LeftToe, WalkerJoint::LeftAnkle, BodyPart::LeftToe, "left_toe", 0,
     walker::ball_height - walker::ankle_height, walker::ankle_to_ball},
    {WalkerJoint::LeftToeTip, WalkerJoint::LeftToe, BodyPart::LeftToeTip, "", 0,
     walker::toe_tip_height - walker::ball_height, walker::toe_length},
    {WalkerJoint::RightHip, WalkerJoint::Hips, BodyPart::RightHip, "right_hip", -walker::hip_half,
     -walker::hip_drop, 0},
    {WalkerJoint::RightKnee, WalkerJoint::RightHip, BodyPart::RightKnee, "right_knee", 0,
     -walker::thigh, 0},
    {WalkerJoint::RightAnkle, WalkerJoint::RightKnee, BodyPart::RightAnkle, "right_ankle", 0,
     -walker::shin, 0},
    {WalkerJoint::RightToe, WalkerJoint::RightAnkle, BodyPart::RightToe, "right_toe", 0,
     walker::ball_height - walker::ankle_height, walker::ankle_to_ball},
    {WalkerJoint::RightToeTip, WalkerJoint::RightToe, BodyPart::RightToeTip, "", 0,
     walker::toe_tip_height - walker::ball_height, walker::toe_length},
}};

}  // namespace

Skeleton gait_skeleton() {
  Skeleton skeleton;
  skeleton.part.fill(JointIndex::None);
  for (const Row& row : rows) {
    const auto index = static_cast<JointIndex>(skeleton.joint.size());
    const bool root = row.joint == row.parent;
    skeleton.joint.push_back(
        {.name = row.name,
         .parent = root ? JointIndex::None : static_cast<JointIndex>(row.parent),
         .offset = Vec3{glm::dvec3{row.x, row.y, row.z}}});
    skeleton.has_rotation.push_back(row.name[0] != '\0');
    skeleton.part[static_cast<std::size_t>(row.part)] = index;
  }
  return skeleton;
}

}  // namespace docent::gait
