#pragma once

#include "runtime/motion/clip_sequence.h"
#include "runtime/motion/draft.h"
#include "runtime/motion/path_track.h"

namespace docent::motion {

/// Lays a sequence onto a track (motion path editing: Gleicher 2001): the body's circle runs along
/// the track, strides stretch evenly so that the motion ends where the track does, and are shorter
/// where the track says. Feet are then replanted: in each foot plant the toe stays at one place and
/// heading, and in between the foot's own motion is bent smoothly from one to the next.
///
/// The first frame takes over `momentum`: position and heading of the body, and both feet where
/// they are. `seed` says how steps differ from each other.
Draft warp_onto(const WalkGraph& graph, const ClipSequence& sequence, const PathTrack& track,
                const Momentum& momentum, std::uint32_t seed);

/// The sequence as it is, not warped.
Draft as_it_is(const WalkGraph& graph, const ClipSequence& sequence);

}  // namespace docent::motion
