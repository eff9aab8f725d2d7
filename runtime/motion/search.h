#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/motion/path_track.h"
#include "runtime/motion/walk_graph.h"

namespace docent::motion {

/// A way through the motion graph: from a frame, over transitions, to a standing end.
struct MotionPlan {
  ClipFrame start;
  std::vector<std::uint32_t> transitions;  ///< Indices into MotionGraph::transitions.
  std::uint32_t last_frame = 0;            ///< Of the clip that the last transition leads to.
  double effort = 0;                       ///< Metres walked by the clips themselves.
  double cost = 0;                         ///< Lower is better, among plans for one track.
  std::uint32_t expanded = 0;              ///< Search states looked at; 0 where no way was found.
  std::uint32_t scope = 0;                 ///< The widest that was searched (walk_graph.h).
  std::uint32_t considered = 0;            ///< Transitions looked at, each as often as it was.
};

/// Where a search begins.
struct MotionStart {
  ClipFrame frame;
  Placement body;  ///< Where the body is then.
};

/// Both searches stay within the graph of the class that they begin in, as far as that walks fairly
/// (walk_graph.h, scopes): what it costs to walk decides how far the motion changes. Where the best
/// state on the way has cost too much they go back to where it had not, and take in the class that
/// is most like walking from there to a little beyond, then the next one; of what they know already
/// only the new transitions are followed. What comes later begins in the first class again. Where
/// the last scope does not walk fairly either, its best way is taken.

/// The best way along a track that will be warped onto it: at each state only the misfit of
/// headings counts, and it is forgotten as the warp takes it up, so the search is one of time and
/// heading alone. A beam search in order of progress that begins at all starts at once.
MotionPlan find_warped_motion(const WalkGraph& graph, const PathTrack& track,
                              std::span<const MotionStart> starts);

/// The best way whose own, unwarped track keeps to the path: deviation to the side and in heading
/// counts all along.
MotionPlan find_raw_motion(const WalkGraph& graph, const PathTrack& track,
                           std::span<const MotionStart> starts);

}  // namespace docent::motion
