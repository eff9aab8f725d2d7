#include "content/avatar/stance.h"

#include <gtest/gtest.h>

#include "content/content_error.h"
#include "content/gait/gait_skeleton.h"

namespace docent::avatar::stance_test {
namespace {

TEST(Stance, StandsOnTheGroundWithHangingArmsAndFeetForward) {
  const Stance stance = stand_at_ease(gait::gait_skeleton());

  EXPECT_NEAR(stance.stature, gait::walker::stature, 0.02);
  for (const LimbPoints& limb : stance.limb) {
    EXPECT_NEAR(limb.toe.y, gait::walker::ball_height, 0.001);
    EXPECT_LT(limb.ankle.y, limb.knee.y);
    EXPECT_LT(limb.wrist.y, limb.elbow.y);
    EXPECT_GT(std::abs(limb.wrist.x), std::abs(limb.shoulder.x));
    EXPECT_GT(limb.foot_forward.z, 0.95F);
  }
}

TEST(Stance, IsTheSameFromATPoseAsFromHangingArms) {
  Skeleton t_pose = gait::gait_skeleton();
  for (const BodyPart part : {BodyPart::LeftElbow, BodyPart::LeftWrist, BodyPart::LeftHandTip,
                              BodyPart::RightElbow, BodyPart::RightWrist, BodyPart::RightHandTip}) {
    Vec3& offset = t_pose.joint[index_of(t_pose[part])].offset;
    const bool left = t_pose[part] < t_pose[BodyPart::RightShoulder];
    offset = {left ? -offset.y : offset.y, 0, 0};
  }

  const Stance hanging = stand_at_ease(gait::gait_skeleton());
  const Stance stretched = stand_at_ease(t_pose);
  for (std::size_t side = 0; side < 2; ++side) {
    EXPECT_LT(glm::length(stretched.limb[side].wrist - hanging.limb[side].wrist), 1e-4F);
    EXPECT_LT(glm::length(stretched.limb[side].elbow - hanging.limb[side].elbow), 1e-4F);
  }
}

TEST(Stance, NeedsAWholeSkeleton) {
  Skeleton headless = gait::gait_skeleton();
  headless.part[static_cast<std::size_t>(BodyPart::Head)] = JointIndex::None;

  EXPECT_THROW(stand_at_ease(headless), content::ContentError);
}

}  // namespace
}  // namespace docent::avatar::stance_test
