#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "content/motion/enrich.h"
#include "content/motion/find_transitions.h"
#include "runtime/model/diagnostic.h"
#include "runtime/model/motion/motion_graph.h"

namespace docent::motion::offline {

/// A clip on its way into the graph, and the file to name when something is wrong with it.
struct SourceClip {
  MotionClip clip;
  std::string file;
  bool role_stated = false;  ///< By clips.toml; otherwise the motion decides.
};

struct MotionOptions {
  TransitionOptions transitions{};
  Enrichment enrichment{};
  unsigned jobs = 1;  ///< Threads. The result is the same for any number.
  /// Gives the recordings to another body, before anything is found in them, and says at which
  /// height, metres, its toe joints rest. May be empty.
  std::function<double(Skeleton& skeleton, std::vector<SourceClip>& sources)> give_to_other{};
  /// Where that is known; else it is judged by the recordings.
  std::optional<double> toe_rest{};
};

/// Makes a motion graph of clips that share a skeleton and a frame rate: levels their ground, finds
/// foot plants, roles and faults of capture, then transitions, and keeps what never dead-ends.
///
/// Clips that neither walk nor run are left out with a warning, and so is what no transition
/// reaches. Where no clip starts, or none stops, such are made of walking, with a warning. Throws
/// ContentError (about `folder`) where that cannot be, or no walk leads from a start to a stop.
/// Deterministic.
MotionGraph make_motion_graph(const Skeleton& skeleton, std::vector<SourceClip> sources,
                              const std::string& folder, const MotionOptions& options,
                              std::vector<Diagnostic>& warnings);

}  // namespace docent::motion::offline
