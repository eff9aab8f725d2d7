#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "runtime/motion/walk_graph.h"

namespace docent::motion {

/// Passages of the motion graph: what a walker can do after a transition, which is a run of frames
/// and then one of the next transitions. The searches and the making of foresight follow them.
/// (crowd::Passage is another thing.)

constexpr double least_seconds = 0.4;  ///< Of plain clip between two blends.
constexpr double look_seconds = 0.1;   ///< Between two looks at the path.
constexpr double blend_cost = 0.012;   ///< Radians squared times metres: a blend costs as much as
                                       ///< walking one metre with the heading off by 6 degrees.
constexpr double distance_cost = 4.0;  ///< Per square metre of a transition's pose distance.

inline double cost_of(const Transition& way) noexcept {
  return blend_cost + distance_cost * static_cast<double>(way.distance * way.distance);
}

/// Goes through frames of a clip in steps of `look_seconds`: calls `step(from, to)` for each.
template <class Step>
void walk_through(const WalkGraph& graph, std::size_t from, std::size_t to, Step step) {
  const auto look = static_cast<std::size_t>(look_seconds * graph.frame_rate) + 1;
  while (from < to) {
    const std::size_t next = std::min(from + look, to);
    step(from, next);
    from = next;
  }
}

/// Which transitions are taken: those of `scope` that lead to a stand, less those that the narrower
/// scope `beyond` takes too.
struct Choice {
  static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t scope = 0, beyond = nothing;
};

inline bool takes(const WalkGraph& graph, const Choice& choice, std::size_t transition) noexcept {
  return leads_to_stand(graph, transition, choice.scope) &&
         (choice.beyond == Choice::nothing || !leads_to_stand(graph, transition, choice.beyond));
}

/// Goes from a frame on through its clip: `step(from, to)` as the frames pass, `leave(transition)`
/// at the middle of each transition that is taken and whose blend begins at `earliest` or later.
/// Returns the frame that it has come to.
template <class Step, class Leave>
std::size_t walk_passages(const WalkGraph& graph, const Choice& choice, ClipFrame at,
                          std::size_t earliest, Step step, Leave leave) {
  const ClipPath& clip = graph.clip[at.clip];
  const auto first = graph.motion->transitions.begin() + clip.first_transition;
  const auto last = graph.motion->transitions.begin() + clip.last_transition;
  const auto before = [](const Transition& way, std::size_t frame) {
    return way.from.frame < frame;
  };
  std::size_t frame = at.frame;
  for (auto way = std::lower_bound(first, last, std::max<std::size_t>(at.frame, earliest), before);
       way != last; ++way) {
    const auto transition = static_cast<std::size_t>(way - graph.motion->transitions.begin());
    if (way->from.frame < earliest + way->radius || !takes(graph, choice, transition)) continue;
    walk_through(graph, frame, way->from.frame, step);
    frame = way->from.frame;
    leave(static_cast<std::uint32_t>(transition));
  }
  return frame;
}

template <class Step, class Leave>
std::size_t walk_from_start(const WalkGraph& graph, const Choice& choice, ClipFrame at, Step step,
                            Leave leave) {
  return walk_passages(graph, choice, at, at.frame, step, leave);
}

/// The same after a transition: first comes `least_seconds` of plain clip, or less where that
/// leaves no next transition.
template <class Step, class Leave>
std::size_t walk_from_transition(const WalkGraph& graph, const Choice& choice,
                                 std::uint32_t transition, Step step, Leave leave) {
  const Transition& came = graph.motion->transitions[transition];
  const std::size_t blended = came.to.frame + came.radius;
  const auto rest = static_cast<std::size_t>(least_seconds * graph.frame_rate);
  bool has_left = false;
  const auto note = [&](std::uint32_t next) {
    has_left = true;
    leave(next);
  };
  const std::size_t frame = walk_passages(graph, choice, came.to, blended + rest, step, note);
  return has_left ? frame : walk_passages(graph, choice, came.to, blended, step, leave);
}

}  // namespace docent::motion
