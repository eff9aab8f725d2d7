#pragma once

#include <array>
#include <span>
#include <vector>

#include "content/motion/pose_distance.h"
#include "runtime/model/motion/motion_graph.h"

namespace docent::motion::offline {

/// The frames of many clips as points in a space of few dimensions, in which the distance of two
/// points is close to the pose distance of their frames, and mostly a little less.
///
/// A point is made of the window round its frame, laid onto the mean of all windows by the rigid
/// motion on the floor that fits best, so that windows that are alike come to lie alike; of this,
/// only the directions in which windows differ most are kept (principal components). Only closeness
/// is promised: whoever needs the distance measures it.
struct PoseFeatures {
  static constexpr std::size_t dimensions = 24;
  using Point = std::array<float, dimensions>;  ///< Metres.

  std::vector<std::size_t> first;  ///< The point of each clip's first frame; and of all, the end.
  std::vector<Point> point;        ///< One a frame, clip after clip.

  const Point& at(std::size_t clip, std::size_t frame) const { return point[first[clip] + frame]; }
};

/// `half` is that of compare_poses. Works on `jobs` threads; the result does not depend on how
/// many.
PoseFeatures make_pose_features(std::span<const PoseCloud> clouds, std::size_t half, unsigned jobs);

/// The square of the distance of two points, m2; the same on every processor.
float square_between(const PoseFeatures::Point& a, const PoseFeatures::Point& b);

}  // namespace docent::motion::offline
