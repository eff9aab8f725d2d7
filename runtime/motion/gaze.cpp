#include <array>
#include <utility>

#include "runtime/motion/pose.h"

namespace docent::motion {
namespace {

/// Of the whole turn, what each part adds. The eyes' part is the head's.
constexpr std::array shares{std::pair{BodyPart::Chest, 0.12F}, std::pair{BodyPart::Neck, 0.38F},
                            std::pair{BodyPart::Head, 0.5F}};

Quat world_rotation_above(const Skeleton& skeleton, JointIndex joint,
                          const PoseView& pose) noexcept {
  Quat rotation(1, 0, 0, 0);
  for (JointIndex at = skeleton.joint[index_of(joint)].parent; at != JointIndex::None;
       at = skeleton.joint[index_of(at)].parent)
    rotation = pose.rotation[index_of(at)] * rotation;
  return rotation;
}

}  // namespace

void turn_head(const Skeleton& skeleton, float angle, PoseView& pose) noexcept {
  if (pose.rotation.size() < skeleton.joint.size()) return;
  float missing = 0;  // what parts that this skeleton lacks would have added
  for (const auto& [part, share] : shares) {
    const JointIndex joint = skeleton[part];
    missing += share;
    if (joint == JointIndex::None) continue;
    const Vec3 up = glm::inverse(world_rotation_above(skeleton, joint, pose)) * Vec3(0, 1, 0);
    Quat& rotation = pose.rotation[index_of(joint)];
    rotation = glm::normalize(glm::angleAxis(angle * std::exchange(missing, 0.0F), up) * rotation);
  }
}

}  // namespace docent::motion
