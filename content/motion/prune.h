#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/motion/motion_graph.h"

namespace docent::motion::offline {

/// What pruning left out, for the report.
struct Pruning {
  std::size_t transitions_dropped = 0;
  std::vector<std::size_t> clips_outside;  ///< Clips that no walk of the graph can use.
};

/// Keeps the transitions on which a walk never runs into a dead end: those within the largest
/// strongly connected part of the graph, those by which a start clip, played from its first frame,
/// comes into that part, and those from it into a stop clip, which may be played to its end.
///
/// A transition of radius L leaves its clip at `from - L` and arrives at `to + L`; between two
/// transitions a clip is played forward. Clips stay in the graph, used or not.
Pruning prune(MotionGraph& graph);

/// The transitions that pruning would keep if there were no clips but those of a class: its own
/// graph, in which a walk never runs into a dead end. Ascending; none where its clips do not meet.
std::vector<std::uint32_t> own_graph(const MotionGraph& graph, const std::string& motion_class);

}  // namespace docent::motion::offline
