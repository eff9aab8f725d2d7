#pragma once

#include <optional>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::crowd {

/// Where a body will be: places at equal times, straight between them, and standing at the last one
/// for ever. Floor frame, metres; seconds of the crowd's clock.
struct Trajectory {
  static constexpr double step = 1.0 / 30;  ///< Seconds between places.

  double start = 0;         ///< When the body leaves the first place; before that it stands there.
  std::vector<Vec2> place;  ///< Never empty.

  double end() const noexcept { return start + step * static_cast<double>(place.size() - 1); }
};

Trajectory standing_trajectory(Vec2 place);

Vec2 place_at(const Trajectory& trajectory, double seconds) noexcept;

/// The first moment, not before `from`, at which two bodies are nearer than `distance`. Exact for
/// what a trajectory says: between two places the least distance of two straight movements counts.
std::optional<double> first_impact(const Trajectory& a, const Trajectory& b, double distance,
                                   double from) noexcept;

}  // namespace docent::crowd
