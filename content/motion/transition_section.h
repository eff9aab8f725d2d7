#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/model/motion/motion_graph.h"

namespace docent::motion::offline {

/// How far a graph's transitions may reach (founding paper, section 3.1.3). A transition is no
/// point but a section of radius L round its two middles: one leaves the source clip at `from - L`
/// and is in the destination clip from `to + L`. Two things ask for a smaller radius:
///
///  - the walker has come into the source clip after `from - L`: the section would begin in its
///    past, and the motion would run backwards;
///  - `to + L` lies behind the last exit of the destination clip: the walker would be in a clip
///    that it cannot leave.
///
/// A radius is shortened to no less than half of the graph's longest, because poses that are alike
/// may be on their way to different places and a short blend would show it. What does not fit even
/// then is not passable. All figures are in frames; all arrays have one entry per transition or
/// clip of the graph.
struct TransitionSections {
  /// The largest radius in front of the last exit; 0 where the transition is not passable: its
  /// destination (unless that is a stop, which may be played to its end) cannot be left.
  std::vector<std::uint32_t> longest;
  std::vector<std::uint32_t> shortest;  ///< At least 1 and at most the graph's own radius.
  /// Per clip: the last frame at which a section can begin; empty where the clip has no exit.
  std::vector<std::optional<std::uint32_t>> last_exit;
};

TransitionSections measure_sections(const MotionGraph& graph);

/// The largest radius with which a walker who is at frame `at` of the transition's source clip can
/// pass it; empty where it is too late.
std::optional<std::uint32_t> section_radius(const MotionGraph& graph,
                                            const TransitionSections& sections, std::uint32_t t,
                                            std::uint32_t at) noexcept;

}  // namespace docent::motion::offline
