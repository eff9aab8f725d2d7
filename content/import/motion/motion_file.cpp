#include "content/import/motion/motion_file.h"

#include <cmath>

namespace docent::import {

double frame_rate_of(double seconds_per_frame) {
  const double rate = 1.0 / seconds_per_frame;
  const double whole = std::round(rate);
  // 29.97 stays what it is; .0083333 is 120 and .033333 is 30.
  constexpr double digits_kept = 5e-4;
  return whole > 0 && std::abs(rate - whole) < digits_kept * rate ? whole : rate;
}

void make_rotations_continuous(MotionClip& clip) {
  for (std::size_t i = clip.joint_count; i < clip.rotation.size(); ++i)
    if (glm::dot(clip.rotation[i], clip.rotation[i - clip.joint_count]) < 0)
      clip.rotation[i] = -clip.rotation[i];
}

void place_joints(const Skeleton& skeleton, const MotionClip& clip, std::size_t frame,
                  std::vector<Vec3>& places) {
  const std::size_t joints = skeleton.joint.size();
  places.resize(joints);
  thread_local std::vector<Quat> turned;
  turned.resize(joints);
  const Quat* rotation = clip.rotation.data() + frame * joints;
  places[0] = clip.root[frame];
  turned[0] = rotation[0];
  for (std::size_t j = 1; j < joints; ++j) {
    const std::size_t parent = index_of(skeleton.joint[j].parent);
    places[j] = places[parent] + turned[parent] * skeleton.joint[j].offset;
    turned[j] = turned[parent] * rotation[j];
  }
}

}  // namespace docent::import
