#pragma once

#include <optional>
#include <span>

#include "content/motion/paper_search.h"
#include "runtime/motion/walk.h"
#include "runtime/motion/walk_graph.h"

namespace docent::motion::offline {

/// What is asked of the paper's search, in the words of the walk command.
struct PaperWalkRequest {
  std::span<const Vec2> path;      ///< Floor frame, at least two different points.
  std::optional<Placement> start;  ///< Standing; facing along the path when absent.
  double lookahead = 1.0;          ///< L_step, metres.
  double use_rate = 0.25;          ///< R_use.
  double time_limit = 600;         ///< Seconds of search, after which the walk ends where it is.
  PaperRequest::Bound bound = PaperRequest::Bound::AsPrinted;
};

/// A walk as the paper's search finds it: from the first start clip, as the body begins to move,
/// along the motion graph's own track. Its fields are those that can be sampled, `plants` and
/// `source`; it ends in mid-stride where the path ends.
struct PaperWalk {
  Walk walk;
  bool reaches_end = false;
  double length = 0;  ///< Metres of track.
};

PaperWalk make_paper_walk(const WalkGraph& graph, const PaperWalkRequest& request);

}  // namespace docent::motion::offline
