#pragma once

#include <array>
#include <span>
#include <vector>

#include "content/motion/path_deviation.h"
#include "runtime/model/motion/motion_graph.h"
#include "runtime/motion/walk.h"

namespace docent::bench {

/// What is seen of a walk, measured on its frames alone.
struct WalkQuality {
  motion::offline::PathDeviation deviation;  ///< Metres, as docent-content(1) defines it.
  double skate = 0;  ///< Metres a second that the toe joint moves while the foot is flat, mean.
  double drift = 0;  ///< Metres that it wanders in one plant; 95 % of the plants are better.
  double flat_share = 0;  ///< Of the feet's frames in which they are flat; skate and drift are not
                          ///< numbers where none is.
  double seconds = 0;
  double end_gap = 0;  ///< Metres between the last root and the path's end.
};

/// Heights (metres) of the ankle and toe joints of a foot that rests on the ground: the lowest
/// percent of the clips. A walk's own lowest frames would be those in which a bad blend drives a
/// foot into the floor.
struct RestingHeights {
  std::array<double, 2> ankle{}, toe{};  ///< Left, right.
};
RestingHeights resting_heights(const MotionGraph& motion);

/// A foot is flat while its ankle is lower than 2 cm and its toe joint lower than 1.5 cm above
/// their resting heights, so that sliding counts and rolling does not.
WalkQuality measure_walk(const Skeleton& skeleton, const RestingHeights& rest,
                         const motion::Walk& walk, std::span<const Vec2> path);

/// The hips on the floor, frame by frame.
std::vector<Vec2> floor_track(const motion::Walk& walk);

}  // namespace docent::bench
