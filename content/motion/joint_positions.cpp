#include "content/motion/joint_positions.h"

#include <algorithm>
#include <cmath>

#include "content/import/motion/body.h"
#include "content/import/motion/motion_file.h"

namespace docent::motion::offline {

JointPositions joint_positions(const Skeleton& skeleton, const MotionClip& clip) {
  JointPositions track{.joints = skeleton.joint.size(), .place = {}};
  track.place.reserve(clip.root.size() * track.joints);
  std::vector<Vec3> places;
  for (std::size_t f = 0; f < clip.root.size(); ++f) {
    import::place_joints(skeleton, clip, f, places);
    track.place.insert(track.place.end(), places.begin(), places.end());
  }
  return track;
}

double size_of(const Skeleton& skeleton) {
  constexpr double adult_leg = 0.83;
  const double leg = import::leg_length(skeleton);
  return leg > 0 ? leg / adult_leg : 1;
}

std::uint32_t frames_in(double seconds, double frame_rate) {
  return static_cast<std::uint32_t>(std::max(1.0, std::round(seconds * frame_rate)));
}

}  // namespace docent::motion::offline
