#include "content/motion/fewer_joints.h"

#include <algorithm>

namespace docent::motion::offline {
namespace {

JointIndex renumbered(JointIndex joint, const std::vector<std::size_t>& kept) {
  if (joint == JointIndex::None) return joint;
  const auto place = std::ranges::lower_bound(kept, index_of(joint));
  return JointIndex{static_cast<std::int32_t>(place - kept.begin())};
}

}  // namespace

std::vector<std::size_t> joints_of_parts(const Skeleton& skeleton) {
  std::vector<bool> needed(skeleton.joint.size());
  needed[0] = true;
  for (JointIndex part : skeleton.part)
    for (; part != JointIndex::None; part = skeleton.joint[index_of(part)].parent)
      needed[index_of(part)] = true;
  std::vector<std::size_t> kept;
  for (std::size_t j = 0; j < needed.size(); ++j)
    if (needed[j]) kept.push_back(j);
  return kept;
}

Skeleton with_joints(const Skeleton& skeleton, const std::vector<std::size_t>& kept) {
  Skeleton fewer{.joint = {}, .has_rotation = {}, .part = skeleton.part};
  for (const std::size_t j : kept) {
    fewer.joint.push_back(skeleton.joint[j]);
    fewer.joint.back().parent = renumbered(skeleton.joint[j].parent, kept);
    fewer.has_rotation.push_back(skeleton.has_rotation[j]);
  }
  for (JointIndex& part : fewer.part) part = renumbered(part, kept);
  return fewer;
}

MotionClip with_joints(const MotionClip& clip, const std::vector<std::size_t>& kept) {
  MotionClip fewer = clip;
  fewer.joint_count = static_cast<std::uint32_t>(kept.size());
  fewer.rotation.clear();
  for (std::size_t f = 0; f < clip.root.size(); ++f)
    for (const std::size_t j : kept)
      fewer.rotation.push_back(clip.rotation[f * clip.joint_count + j]);
  return fewer;
}

}  // namespace docent::motion::offline
