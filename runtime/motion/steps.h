#pragma once

#include <span>
#include <vector>

#include "runtime/motion/draft.h"
#include "runtime/motion/path_track.h"

namespace docent::motion {

/// One step: a foot is lifted and set down where it belongs when the body stands at `station`.
struct Step {
  Side foot = Side::Left;
  Placement station;
};

/// Steps that turn a standing body on the spot by `angle` (radians, any size and sign), beginning
/// with the foot on the side of the turn or, where one is in the air, with that one.
std::vector<Step> plan_turn(const Placement& from, double angle, const Momentum& momentum);

/// Small steps along a short track, for ways that are too short for a start and a stop.
std::vector<Step> plan_short_walk(const PathTrack& track, const Momentum& momentum);

/// Makes the steps, from a moment at which the body hardly moves to a stand at the last station.
/// The body turns and shifts its weight over the standing foot; the head leads.
Draft make_steps(const WalkGraph& graph, const Momentum& momentum, std::span<const Step> steps,
                 const Stand& goal, Gait gait);

}  // namespace docent::motion
