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
  double effort = 0;                       ///< Metres that the clips themselves walk.
  double cost = 0;                         ///< Lower is better, among plans for one track.
  std::uint32_t expanded = 0;              ///< Search states looked at; 0 where no way was found.
  std::uint32_t scope = 0;                 ///< The widest that was searched (walk_graph.h).
  std::uint32_t considered = 0;            ///< Transitions looked at, counted each time.
};

/// Where a search begins.
struct MotionStart {
  ClipFrame frame;
  Placement body;  ///< Where the body is then.
};

/// Both searches stay within the scope that they begin in (WalkGraph) as long as its best way is
/// fair, which means that it has not cost too much so far. Where it is not, they go back to where
/// it was, and from there to a little beyond the trouble search in the next wider scope, and so on;
/// only transitions that are new in it are followed then. What comes later begins in the first
/// scope again. Where the widest scope has no fair way either, its best way is taken.

/// The best motion to be warped onto a track: at each state only the misfit of headings counts, and
/// it fades as the warp takes it up, so the search is one of time and heading alone. A beam search
/// in order of progress that begins at all starts at once.
MotionPlan find_warped_motion(const WalkGraph& graph, const PathTrack& track,
                              std::span<const MotionStart> starts);

/// The best motion that keeps to the track by itself, without a warp: deviation to the side and in
/// heading counts all along.
MotionPlan find_raw_motion(const WalkGraph& graph, const PathTrack& track,
                           std::span<const MotionStart> starts);

}  // namespace docent::motion
