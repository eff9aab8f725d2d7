#pragma once

#include <cmath>
#include <vector>

#include "content/motion/paper_search.h"

namespace docent::motion::offline {

/// T: what a path of the paper's search looks like, frame by frame. World frame, metres; `rotation`
/// has one entry per frame and joint, as in MotionClip.
struct PaperTrack {
  std::vector<Vec3> root;
  std::vector<Quat> rotation;
  std::vector<ClipFrame> source;  ///< The clip frame that has the larger share.
};

/// pathToTrack: plays the clips one after another and blends them over the transitions' sections.
/// `clip_to_floor` lays the first clip onto the floor.
PaperTrack make_paper_track(const MotionGraph& graph, const PaperPath& path,
                            const Placement& clip_to_floor);

/// The destination's share in frame i (from 0) of the 2 * radius frames of a section: rises
/// smoothly from 0 to 1, at rest at both ends.
inline double blend_share(std::uint32_t i, std::uint32_t radius) noexcept {
  const double t = (i + 0.5) / (2.0 * radius);
  return t * t * t * (t * (6 * t - 15) + 10);
}

/// A point of the floor carried along by a rigid motion.
inline Vec2 carried(const Placement& motion, Vec2 p) noexcept {
  const double c = std::cos(motion.heading), s = std::sin(motion.heading);
  return motion.position + Vec2{c * p.x - s * p.y, s * p.x + c * p.y};
}

/// `inner` first, then `outer`.
inline Placement carried(const Placement& outer, const Placement& inner) noexcept {
  return {carried(outer, inner.position), outer.heading + inner.heading};
}

}  // namespace docent::motion::offline
