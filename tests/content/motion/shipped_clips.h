#pragma once

#include <vector>

#include "content/motion/make_motion_graph.h"

namespace docent::test {

/// The clips that docent ships, as they are read.
struct ShippedClips {
  Skeleton skeleton;
  std::vector<motion::offline::SourceClip> clips;

  /// One of them, by its name.
  [[nodiscard]] const MotionClip& named(const std::string& name) const;
};

const ShippedClips& shipped_clips();

/// Their motion graph, made once.
const MotionGraph& shipped_graph();

}  // namespace docent::test
