#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "runtime/motion/walk.h"
#include "runtime/motion/walk_graph.h"

namespace docent::bench {

/// What a frame of a clip is told by, relative to the body that stands and faces there: where it
/// will be in a third, two thirds and one second (2 each), which way it will face then (2 each),
/// place and velocity of both toe joints (3 each) and the hips' velocity (3).
using MatchingFeatures = std::array<double, 27>;

/// Plain motion matching (Clavet 2016), to compare with: ten times a second, and where a clip ends,
/// the frame of all clips whose features are nearest to those of the body as it is and of the path
/// ahead; where that is another passage, it jumps there, and what differs fades (Bollo 2018). No
/// transitions are found beforehand and no foot is pinned.
class MotionMatcher {
 public:
  explicit MotionMatcher(const motion::WalkGraph& graph);

  /// Walks along a path (floor frame, at least two different points) from standing, until it
  /// stands at the end or twice the time has passed that an ordinary walk takes.
  [[nodiscard]] motion::Walk walk_along(std::span<const Vec2> path,
                                        std::optional<Placement> start) const;

 private:
  friend class MatchedWalk;

  const motion::WalkGraph& graph_;
  std::vector<ClipFrame> frame_;  ///< Every frame that can be jumped to, clip by clip.
  std::vector<std::uint32_t> first_of_clip_;
  std::vector<MatchingFeatures> features_;  ///< Normalised and weighted.
  MatchingFeatures mean_{}, scale_{};
};

}  // namespace docent::bench
