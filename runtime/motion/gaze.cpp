#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/motion/pose.h"

namespace docent::motion {
namespace {

/// Of the whole turn, what each part adds. The eyes' part is the head's.
struct Share {
  BodyPart part;
  float yaw, pitch;
};
constexpr std::array shares{
    Share{BodyPart::Spine, 0.10F, 0.0F}, Share{BodyPart::Chest, 0.18F, 0.08F},
    Share{BodyPart::Neck, 0.32F, 0.42F}, Share{BodyPart::Head, 0.40F, 0.5F}};

constexpr double quickness = 7;  // of the spring, 1/s
constexpr double most_rate = 3.2;

Quat world_rotation_above(const Skeleton& skeleton, JointIndex joint,
                          const PoseView& pose) noexcept {
  Quat rotation(1, 0, 0, 0);
  for (JointIndex at = skeleton.joint[index_of(joint)].parent; at != JointIndex::None;
       at = skeleton.joint[index_of(at)].parent)
    rotation = pose.rotation[index_of(at)] * rotation;
  return rotation;
}

/// Moves a number towards a wish in exact steps of a critically damped spring; far off, as if it
/// were nearer, so that it is never too quick.
void follow(double wish, double seconds, double& value, double& rate) noexcept {
  constexpr double farthest = 2 * most_rate / quickness;  // where the spring goes at that rate
  const double off = std::clamp(value - wish, -farthest, farthest);
  const double begin = value - off;
  const double moved = (rate + quickness * off) * seconds, decay = std::exp(-quickness * seconds);
  value = begin + (off + moved) * decay;
  rate = (rate - quickness * moved) * decay;
}

}  // namespace

void follow_gaze(double yaw, double pitch, double seconds, Gaze& gaze) noexcept {
  if (!(seconds > 0)) return;
  follow(std::clamp(yaw, -most_gaze_yaw, most_gaze_yaw), seconds, gaze.yaw, gaze.yaw_rate);
  follow(std::clamp(pitch, -most_gaze_down, most_gaze_up), seconds, gaze.pitch, gaze.pitch_rate);
}

Gaze gaze_at(Vec3 target, Vec3 eye, double heading) noexcept {
  const Vec3 line = target - eye;
  const double level = std::hypot(line.x, line.z);
  if (level < 0.05) return {};
  const Vec2 on_floor = to_floor(line);
  return {.yaw = std::remainder(std::atan2(on_floor.y, on_floor.x) - heading, 2 * std::numbers::pi),
          .pitch = std::atan2(static_cast<double>(line.y), level)};
}

void turn_head(const Skeleton& skeleton, const Gaze& gaze, PoseView& pose) noexcept {
  if (pose.rotation.size() < skeleton.joint.size()) return;
  const auto yaw = static_cast<float>(gaze.yaw), pitch = static_cast<float>(gaze.pitch);
  const Vec3 up(0, 1, 0);
  Vec3 right = glm::cross(pose.rotation[0] * Vec3(0, 0, 1), up);
  const float level = glm::length(right);
  right = level > 1e-3F ? right / level : Vec3(-1, 0, 0);
  float yaw_share = 0, pitch_share = 0, turned = 0;  // lacking parts' shares go to the next
  for (const Share& share : shares) {
    yaw_share += share.yaw;
    pitch_share += share.pitch;
    const JointIndex joint = skeleton[share.part];
    if (joint == JointIndex::None) continue;
    turned += yaw * yaw_share;
    // Nodding is about the axis across where the head looks by now.
    const Vec3 across = glm::angleAxis(turned, up) * right;
    const Quat turn = glm::angleAxis(pitch * std::exchange(pitch_share, 0.0F), across) *
                      glm::angleAxis(yaw * std::exchange(yaw_share, 0.0F), up);
    const Quat above = world_rotation_above(skeleton, joint, pose);
    Quat& rotation = pose.rotation[index_of(joint)];
    rotation = glm::normalize(glm::inverse(above) * turn * above * rotation);
  }
}

}  // namespace docent::motion
