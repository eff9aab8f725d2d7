#pragma once

#include <functional>
#include <span>
#include <vector>

#include "content/motion/pose_distance.h"
#include "runtime/model/motion/motion_graph.h"

namespace docent::motion::offline {

/// A piece of the distance matrix of two clips, the first not after the second.
struct PairTile {
  std::uint32_t a = 0, b = 0;
  TilePlace place;
  auto operator<=>(const PairTile&) const = default;
};

/// Every piece of every two clips' matrix, in order.
std::vector<PairTile> every_tile(std::span<const PoseCloud> clouds);

/// What to look for in a crowd of poses.
struct AlikeSearch {
  std::size_t half = 0;       ///< Frames of a window to each side of its middle.
  std::uint32_t apart = 0;    ///< Frames: of so many one is looked up.
  double threshold = 0;       ///< Metres: up to this pose distance, frames are alike.
  std::size_t looked_up = 0;  ///< Poses that are found in the index for each that is looked up.
  std::size_t kept = 0;       ///< Of them, pairs whose pieces are returned.
  /// Whether a pair is wanted at all, as far as can be told without its distance.
  std::function<bool(ClipFrame, ClipFrame)> may_meet;
};

/// The pieces in which the closest of the pairs lie that are alike, in order. It takes a time that
/// grows little faster than the number of frames.
///
/// One frame in each `apart` is looked up among all the others (NearestPoses). Each pair found is
/// moved to the least distance of PoseFeatures nearby, those that run beside each other count as
/// one, and the `kept` closest are returned. So in a crowd where all are alike it finds those that
/// are most alike, and of a few it finds all. Works on `jobs` threads; the result does not depend
/// on how many.
std::vector<PairTile> alike_tiles(std::span<const PoseCloud> clouds, const AlikeSearch& search,
                                  unsigned jobs);

}  // namespace docent::motion::offline
