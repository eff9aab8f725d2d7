#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "content/motion/pose_features.h"

namespace docent::motion::offline {

/// Finds the points that are closest to a point: a tree of boxes, each of which is cut in the
/// middle of its longest side (Bentley 1975, with the boxes drawn tightly round their points, since
/// motion fills only a thin part of its space). Immutable; any thread may ask.
class NearestPoses {
 public:
  /// Borrows nothing: it holds the points in its own order.
  NearestPoses() = default;
  explicit NearestPoses(std::span<const PoseFeatures::Point> points);

  struct Neighbour {
    float square = 0;  ///< Of the distance, m2.
    std::uint32_t index = 0;
    auto operator<=>(const Neighbour&) const = default;
  };

  /// The `count` points that are closest to `point`, itself included where it is one of them, and
  /// not farther than `within` metres; closest first, of equally close ones the one with the lower
  /// index.
  void find(const PoseFeatures::Point& point, std::size_t count, float within,
            std::vector<Neighbour>& nearest) const;

 private:
  struct Box {
    PoseFeatures::Point low, high;
    std::uint32_t first = 0, end = 0;  ///< Its points.
    std::uint32_t second_half = 0;     ///< Boxes; the first half follows its box. 0 for a leaf.
  };

  void add_box(std::uint32_t first, std::uint32_t end, std::span<const PoseFeatures::Point> points);

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> index_;
  std::vector<PoseFeatures::Point> point_;  ///< In the order of index_.
};

}  // namespace docent::motion::offline
