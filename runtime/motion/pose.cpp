#include "runtime/motion/pose.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace docent::motion {
namespace {

/// A moment between two frames.
struct Between {
  std::size_t first = 0, second = 0;
  float share = 0;  ///< Of the second.
};

Between between_frames(double seconds, double frame_rate, std::size_t frames) noexcept {
  const double last = static_cast<double>(frames - 1);
  const double at = seconds > 0 ? std::min(seconds * frame_rate, last) : 0.0;
  const auto first = static_cast<std::size_t>(at);
  const std::size_t second = std::min(first + 1, frames - 1);
  return {first, second, static_cast<float>(at - static_cast<double>(first))};
}

/// Walk and MotionClip keep their frames alike.
template <typename Motion>
void sample_motion(const Motion& motion, double seconds, PoseView& pose) noexcept {
  if (motion.root.empty()) return;
  const Between moment = between_frames(seconds, motion.frame_rate, motion.root.size());
  const std::size_t joints = motion.joint_count;
  const Quat* first = motion.rotation.data() + moment.first * joints;
  const Quat* second = motion.rotation.data() + moment.second * joints;
  pose.root = glm::mix(motion.root[moment.first], motion.root[moment.second], moment.share);
  const std::size_t count = std::min(joints, pose.rotation.size());
  for (std::size_t j = 0; j < count; ++j) {
    const Quat to = glm::dot(first[j], second[j]) < 0 ? -second[j] : second[j];
    // Frames are a few degrees apart, where the chord and the arc agree to a millionth.
    pose.rotation[j] = glm::normalize(first[j] * (1 - moment.share) + to * moment.share);
  }
}

}  // namespace

void sample(const Walk& walk, double seconds, PoseView& pose) noexcept {
  sample_motion(walk, seconds, pose);
}

void sample(const MotionClip& clip, double seconds, PoseView& pose) noexcept {
  sample_motion(clip, seconds, pose);
}

void to_world_space(const Skeleton& skeleton, const PoseView& pose,
                    std::span<Mat4> world) noexcept {
  const std::size_t count = std::min({skeleton.joint.size(), pose.rotation.size(), world.size()});
  for (std::size_t j = 0; j < count; ++j) {
    const Joint& joint = skeleton.joint[j];
    Mat4 local = glm::mat4_cast(pose.rotation[j]);
    if (joint.parent == JointIndex::None) {
      local[3] = Vec4(pose.root, 1);
      world[j] = local;
    } else {
      local[3] = Vec4(joint.offset, 1);
      world[j] = world[index_of(joint.parent)] * local;
    }
  }
}

JointPlace place_of(const Skeleton& skeleton, JointIndex joint, const PoseView& pose) noexcept {
  JointPlace at;
  while (joint != JointIndex::None) {
    const Joint& one = skeleton.joint[index_of(joint)];
    const Quat& rotation = pose.rotation[index_of(joint)];
    const bool is_root = one.parent == JointIndex::None;
    at.place = (is_root ? pose.root : one.offset) + rotation * at.place;
    at.rotation = rotation * at.rotation;
    joint = one.parent;
  }
  at.rotation = glm::normalize(at.rotation);
  return at;
}

void fill_skinning_palette(std::span<const Mat4> world, std::span<const Mat4> inverse_bind,
                           std::span<Mat4> palette) noexcept {
  const std::size_t count = std::min({world.size(), inverse_bind.size(), palette.size()});
  for (std::size_t j = 0; j < count; ++j) palette[j] = world[j] * inverse_bind[j];
}

}  // namespace docent::motion
