#pragma once

#include <span>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::bench {

/// A disc that avoids others by optimal reciprocal collision avoidance (van den Berg, Guy, Lin,
/// Manocha 2011). Metres, seconds.
struct OrcaBody {
  Vec2 position{}, velocity{};
  double radius = 0.25;
  double most_speed = 1.5;
};

struct OrcaSettings {
  double horizon = 4;       ///< Seconds ahead in which others are not met.
  double wall_horizon = 1;  ///< And walls.
  double step = 1.0 / 60;
};

/// A wall from a to b.
struct OrcaWall {
  Vec2 a{}, b{};
};

/// The velocity nearest to the preferred one that no half-plane forbids, or, where there is none,
/// one that goes least against them. A wall forbids to come nearer to its nearest point than within
/// its horizon.
Vec2 orca_velocity(std::span<const OrcaBody> bodies, std::size_t self, Vec2 preferred,
                   std::span<const OrcaWall> walls, const OrcaSettings& settings);

}  // namespace docent::bench
