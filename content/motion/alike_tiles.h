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

/// What to look for among many poses.
struct AlikeSearch {
  std::size_t half = 0;       ///< Frames of a window to each side of its middle.
  std::uint32_t apart = 0;    ///< Frames: one of each so many is looked up.
  double threshold = 0;       ///< Metres: frames are alike up to this pose distance.
  std::size_t looked_up = 0;  ///< Neighbours that are found for each frame looked up.
  std::size_t kept = 0;       ///< How many of them, at most, have their pieces returned.
  /// Whether a pair is wanted at all, as far as can be told without its distance.
  std::function<bool(ClipFrame, ClipFrame)> may_meet;
};

/// The pieces in which the closest of the pairs lie that are alike, in order. It takes a time that
/// grows little faster than the number of frames.
///
/// One frame in each `apart` is looked up among the others so chosen (NearestPoses). Each pair
/// found is moved to the least distance of PoseFeatures nearby, pairs that run beside each other
/// count as one, and the `kept` closest of each frame looked up are returned. So among many that
/// are alike it finds those that are most alike, and of a few it finds all. Works on `jobs`
/// threads; the result does not depend on how many.
std::vector<PairTile> alike_tiles(std::span<const PoseCloud> clouds, const AlikeSearch& search,
                                  unsigned jobs);

}  // namespace docent::motion::offline
