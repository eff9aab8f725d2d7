#pragma once

#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "content/gait/gait.h"
#include "content/gait/gait_skeleton.h"

namespace docent::gait {

/// World places and rotations of the walker's joints in every frame, by plain forward kinematics.
class GaitTrack {
 public:
  explicit GaitTrack(const MotionClip& clip) : frames_{clip.root.size()} {
    const Skeleton skeleton = gait_skeleton();
    const std::size_t joints = skeleton.joint.size();
    for (std::size_t f = 0; f < frames_; ++f)
      for (std::size_t j = 0; j < joints; ++j) {
        const glm::dquat local(clip.rotation[f * joints + j]);
        if (j == 0) {
          place_.emplace_back(clip.root[f]);
          turn_.push_back(local);
          continue;
        }
        const std::size_t parent = f * joints + index_of(skeleton.joint[j].parent);
        place_.push_back(place_[parent] + turn_[parent] * glm::dvec3(skeleton.joint[j].offset));
        turn_.push_back(turn_[parent] * local);
      }
  }

  std::size_t frames() const { return frames_; }
  glm::dvec3 place(std::size_t frame, WalkerJoint joint) const { return place_[at(frame, joint)]; }
  glm::dquat turn(std::size_t frame, WalkerJoint joint) const { return turn_[at(frame, joint)]; }

  /// Radians, left positive: where a joint faces on the ground.
  double heading(std::size_t frame, WalkerJoint joint) const {
    const glm::dvec3 ahead = turn(frame, joint) * glm::dvec3{0, 0, 1};
    return std::atan2(ahead.x, ahead.z);
  }
  /// Of the body: pelvis and chest turn against each other, so their mean hardly sways.
  double heading(std::size_t frame) const {
    return 0.5 * (heading(frame, WalkerJoint::Hips) + heading(frame, WalkerJoint::Chest));
  }
  /// Radians between thigh and shin, 0 when straight.
  double knee(std::size_t frame, Side foot) const {
    const auto [hip, knee, ankle, toe] = leg(foot);
    const glm::dvec3 thigh = glm::normalize(place(frame, knee) - place(frame, hip));
    const glm::dvec3 shin = glm::normalize(place(frame, ankle) - place(frame, knee));
    return std::acos(std::min(1.0, glm::dot(thigh, shin)));
  }
  /// Does the heel or the ball of the foot touch the ground?
  bool touches(std::size_t frame, Side foot) const {
    constexpr double touch = 0.0005;
    const auto [hip, knee, ankle, toe] = leg(foot);
    const glm::dvec3 heel =
        place(frame, ankle) +
        turn(frame, ankle) * glm::dvec3{0, -walker::ankle_height, -walker::heel_behind};
    return heel.y < touch || place(frame, toe).y < walker::ball_height + touch;
  }

  struct LegJoints {
    WalkerJoint hip, knee, ankle, toe;
  };
  static LegJoints leg(Side foot) {
    using enum WalkerJoint;
    return foot == Side::Left ? LegJoints{LeftHip, LeftKnee, LeftAnkle, LeftToe}
                              : LegJoints{RightHip, RightKnee, RightAnkle, RightToe};
  }

 private:
  std::size_t at(std::size_t frame, WalkerJoint joint) const {
    return frame * static_cast<std::size_t>(WalkerJoint::Count) + static_cast<std::size_t>(joint);
  }

  std::size_t frames_;
  std::vector<glm::dvec3> place_;
  std::vector<glm::dquat> turn_;
};

}  // namespace docent::gait
