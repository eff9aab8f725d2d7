#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "runtime/model/motion/motion_graph.h"

namespace docent::motion::offline {

/// The search that the founding paper prints (Wang, Meng, Yang, Zhang, section 3.1.2), for
/// comparison: incremental depth-first search with a stack, which tries every way of the next
/// `lookahead` metres and keeps the first part of the best. The symbols of the paper stand beside
/// the names.
///
/// What the paper leaves open is decided so:
///  - a vertex is a frame at which a section begins (or the walker has just arrived by one); its
///    neighbours are the clip's next vertex and the ends of the transitions that begin there;
///  - sections are shortened as transition_section.h says, and a clip is played past its last exit
///    only where that reaches the end of the path;
///  - D is the mean squared distance between points at equal arc length of the two tracks, and the
///    avatar's track is the hips' on the floor, with the sway of the gait in it;
///  - L_opt is the length of what is kept, not of the whole last candidate: else the length looked
///    ahead, and with it the time, would grow from step to step wherever R_use is below 1;
///  - R_use of the vertices are kept, rounded down, at least one; of the step that reaches the end
///    of the path all, and the track ends there, in mid-stride.

/// What is walked along, and how hard to look.
struct PaperRequest {
  std::span<const Vec2> path;  ///< T_obj: floor frame, metres, at least two different points.
  ClipFrame start;             ///< V_ini.
  Placement clip_to_floor;     ///< M_i: lays the start's clip onto the floor.
  double lookahead = 1.0;      ///< L_step, metres; positive.
  double use_rate = 0.25;      ///< R_use, in (0, 1].
  double time_limit = std::numeric_limits<double>::infinity();  ///< Seconds.
  /// AsPrinted: a candidate is judged when it is long enough. OnTheWay: one that is already worse
  /// than the best is given up, which finds the same track sooner.
  enum class Bound : std::uint8_t { AsPrinted, OnTheWay } bound = Bound::AsPrinted;
};

/// A transition and the radius, in frames, that it is passed with.
struct PassedTransition {
  std::uint32_t transition = 0;
  std::uint32_t radius = 0;
};

/// P_result: from the start over transitions to a frame of the clip that the last one leads to.
struct PaperPath {
  ClipFrame start;
  std::vector<PassedTransition> passed;
  std::uint32_t last_frame = 0;
  std::uint32_t frames = 1;    ///< Of its track, which may end within the last blend.
  double length = 0;           ///< Of its track, metres: that of the path, unless cut short.
  std::uint64_t expanded = 0;  ///< Candidates taken from the stack.
  double seconds = 0;          ///< That the search took.
  bool reaches_end = false;    ///< False where the time was up or no candidate was long enough.
};

/// Deterministic but for the time limit.
PaperPath find_paper_path(const MotionGraph& graph, const PaperRequest& request);

}  // namespace docent::motion::offline
