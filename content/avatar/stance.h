#pragma once

#include <array>
#include <vector>

#include "runtime/model/motion/side.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::avatar {

/// Joint places of one leg and one arm in the stance pose (model frame, metres).
struct LimbPoints {
  Vec3 hip, knee, ankle, toe;              ///< `toe` is the ball of the foot.
  Vec3 foot_forward;                       ///< Unit, horizontal: where the foot points.
  Vec3 shoulder, elbow, wrist, hand_axis;  ///< `hand_axis` is a unit vector from wrist to fingers.
};

/// A skeleton standing at ease: the pose in which the body is modelled and bound. Model frame:
/// metres, y up, facing +z, soles at y = 0, the middle of the hip joints at x = z = 0.
struct Stance {
  std::vector<Mat4> world;  ///< Joint to model frame, one per joint.
  std::array<LimbPoints, 2> limb;
  Vec3 neck, head;       ///< Joints; `head` is at the base of the skull.
  float stature = 1.7F;  ///< Metres, judged from the heights of hips and shoulders.
};

/// Lets the legs and arms of a skeleton hang and its feet point forward; the spine stays as it is.
///
/// Rest poses differ (arms stretched out, legs astride), so each limb is turned the shortest way
/// from where its bone points at rest to where it points in the stance. That keeps the thumbs
/// forward both for a T-pose with palms down and for arms that hang already.
/// ContentError when a part of the body is missing.
Stance stand_at_ease(const Skeleton& skeleton);

}  // namespace docent::avatar
