#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "runtime/model/motion/motion_graph.h"
#include "runtime/model/motion/side.h"
#include "runtime/motion/walk.h"
#include "runtime/motion/walk_graph.h"

namespace docent::bench {

/// Where the parts of a body are, frame by frame: what a measure of a motion looks at, be it a clip
/// or a walk. World frame, metres; a part that a skeleton has not is at its hips.
struct TrackedMotion {
  using Parts = std::array<Vec3, static_cast<std::size_t>(BodyPart::Count)>;

  double rate = 120;
  std::vector<Parts> part;
  std::vector<Placement> body;  ///< The body's circle.
  std::vector<FootPlants> plants;
  std::vector<bool> is_walking;  ///< Neither stands nor turns on the spot.

  std::size_t frames() const { return part.size(); }
  Vec3 at(std::size_t frame, BodyPart p) const { return part[frame][static_cast<std::size_t>(p)]; }
  bool planted(std::size_t frame, Side side) const {
    return side == Side::Left ? plants[frame].left : plants[frame].right;
  }
  std::size_t frames_in(double seconds) const {
    return static_cast<std::size_t>(std::lround(seconds * rate));
  }
};

TrackedMotion track(const Skeleton& skeleton, const motion::Walk& walk);
/// A clip of the graph, from where its motion begins to where it has ended.
TrackedMotion track(const motion::WalkGraph& graph, std::size_t clip);
/// All clips of a graph.
std::vector<TrackedMotion> track_clips(const motion::WalkGraph& graph);

/// A place in the frame of a body: metres ahead of it, up, and to its left.
Vec3 seen_from(const Placement& body, Vec3 place);

/// Frames in which a foot has come down to stand while the body walks.
std::vector<std::size_t> strikes(const TrackedMotion& motion, Side side);

}  // namespace docent::bench
