#pragma once

#include <optional>

#include "runtime/model/geometry/treads.h"
#include "runtime/motion/walk_graph.h"

namespace docent::motion {

/// What is asked of a body at a flight of steps: to go straight from one stop to the other.
struct ClimbRequest {
  Treads treads;      ///< By distances from `from` towards `to`.
  Vec2 from{}, to{};  ///< Floor frame: the stops, apart from each other.
  Placement start;    ///< Where the body stands: at the first stop, facing anywhere.
  double final_heading = 0;
  const Walk* previous = nullptr;  ///< The walk in which it stands; null: it appears.
  std::uint32_t previous_frame = 0;
  double seconds = 0;  ///< Which it should take; nobody runs or dawdles for that.
};

/// Climbs or descends the flight one tread after the other, one foot after the other, each flat on
/// its tread and clear of the edges that it passes. Heights of the walk are those above the straight
/// line between the two floors: who draws it adds `share of the way from stop to stop` times the
/// rise, and has feet on the treads. Nothing where treads are too steep for a leg: such a flight is
/// glided.
///
/// Feet while they stand are on the tread to rounding, except where a leg is too short for it.
std::optional<Walk> make_climb(const WalkGraph& graph, const ClimbRequest& request);

}  // namespace docent::motion
