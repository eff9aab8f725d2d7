#pragma once

#include <vector>

#include "runtime/motion/arm.h"

namespace docent::test {

/// The stick figure with its arms stretched out to its sides, with collar bones, hands, and a bone
/// in the forearm that twists.
Skeleton stretched_figure();

/// A figure whose arms can be posed, standing however it was turned.
struct ArmedFigure {
  explicit ArmedFigure(Skeleton shape);

  /// Holds an arm so, and returns where its joints are, in the order of Arm::joint, then the
  /// fingers' tips.
  std::vector<Vec3> hold(Side side, const motion::ArmPosture& posture);
  motion::JointPlace trunk(Side side);
  motion::PoseView pose() { return {.root = {0.3F, 0.9F, -2}, .rotation = rotation}; }

  Skeleton skeleton;
  motion::Arms arms;
  std::vector<Quat> rotation;
};

/// What a clinician would measure, seen from the trunk; radians.
struct MeasuredArm {
  float elevation = 0;  ///< Of the upper arm, from hanging.
  float azimuth = 0;    ///< Of the upper arm from straight ahead, outwards positive.
  float elbow = 0;      ///< Between upper arm and forearm; 0 where they are in line.
  float wrist = 0;      ///< Between forearm and hand.
};
MeasuredArm measured(const std::vector<Vec3>& joints, const motion::Arm& arm,
                     const motion::JointPlace& trunk);

}  // namespace docent::test
