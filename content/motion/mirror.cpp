#include "content/motion/mirror.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "content/content_error.h"
#include "content/import/motion/body.h"
#include "content/motion/joint_positions.h"

namespace docent::motion::offline {
namespace {

/// Metres by which a bone of an adult may differ from its counterpart's reflection. The shoulders
/// of CMU's subject 16 differ by 2.4 cm, the bones of his legs by 1 cm at most.
constexpr float most_askew = 0.04f;

Vec3 reflected(Vec3 v) {
  return {-v.x, v.y, v.z};
}
/// Turns are pseudovectors: a mirror keeps the part about its normal and reverses the others.
Quat reflected(const Quat& q) {
  return {q.w, q.x, -q.y, -q.z};
}

ClipRole reflected(ClipRole role) {
  if (role == ClipRole::TurnLeft) return ClipRole::TurnRight;
  return role == ClipRole::TurnRight ? ClipRole::TurnLeft : role;
}

/// The joint below `parent` that could be `joint` in a mirror, and is closest to it.
std::size_t counterpart_below(const Skeleton& skeleton, std::size_t parent, std::size_t joint) {
  const Joint& sought = skeleton.joint[joint];
  const auto askew = [&](std::size_t j) {
    return glm::distance(skeleton.joint[j].offset, reflected(sought.offset));
  };
  std::size_t best = skeleton.joint.size();
  for (std::size_t j = parent + 1; j < skeleton.joint.size(); ++j) {
    const Joint& other = skeleton.joint[j];
    if (index_of(other.parent) != parent ||
        skeleton.has_rotation[j] != skeleton.has_rotation[joint])
      continue;
    // An end site has no name of its own.
    if (skeleton.has_rotation[j] && !import::are_counterparts(sought.name, other.name)) continue;
    if (best == skeleton.joint.size() || askew(j) < askew(best)) best = j;
  }
  const float allowed = most_askew * static_cast<float>(size_of(skeleton));
  return best < skeleton.joint.size() && askew(best) <= allowed ? best : skeleton.joint.size();
}

}  // namespace

std::vector<std::size_t> find_counterparts(const Skeleton& skeleton, const std::string& folder) {
  std::vector<std::size_t> counterpart(skeleton.joint.size(), 0);
  const auto require = [&](bool is_there, std::size_t j) {
    if (is_there) return;
    throw content::ContentError(
        folder, 0, 0, "no-mirror",
        fmt::format("clips cannot be mirrored: joint '{}' has no counterpart of the other side",
                    skeleton.joint[j].name),
        "mirrored are skeletons whose sides have the same joints, by names such as LeftArm and "
        "RightArm, and the same bones in a rest pose that faces straight ahead");
  };
  for (std::size_t j = 1; j < counterpart.size(); ++j) {
    const std::size_t parent = counterpart[index_of(skeleton.joint[j].parent)];
    counterpart[j] = counterpart_below(skeleton, parent, j);
    require(counterpart[j] < counterpart.size(), j);
  }
  for (std::size_t j = 1; j < counterpart.size(); ++j)  // Two joints may have found the same one.
    require(counterpart[counterpart[j]] == j, j);
  return counterpart;
}

MotionClip mirrored(const std::vector<std::size_t>& counterpart, const MotionClip& clip) {
  MotionClip result = clip;
  result.role = reflected(clip.role);
  for (Vec3& root : result.root) root = reflected(root);
  for (std::size_t f = 0; f < clip.root.size(); ++f)
    for (std::size_t j = 0; j < clip.joint_count; ++j)
      result.rotation[f * clip.joint_count + j] =
          reflected(clip.rotation[f * clip.joint_count + counterpart[j]]);
  for (FootPlants& feet : result.plants) std::swap(feet.left, feet.right);
  return result;
}

}  // namespace docent::motion::offline
