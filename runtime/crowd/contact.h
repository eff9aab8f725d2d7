#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/model/geometry/vec2.h"

/// When two moving discs touch. Detection and planning use the same functions.
namespace docent::crowd {

/// For rounding, far below what anybody notices. Metres.
inline constexpr double margin = 1e-6;

/// From when to when two discs overlap or touch if both keep their velocity; seconds from now.
struct Collision {
  double first = 0;  ///< 0 where they touch already.
  double last = 0;   ///< At most the horizon.
};

/// Two moving discs seen as one that moves towards another that stands. Metres and seconds.
struct Approach {
  double beyond = 0;   ///< Distance squared less reach squared: positive where they are apart.
  double nearing = 0;  ///< Half the rate at which the squared distance falls.
  double speed_squared = 0;
  double square = 0;  ///< Negative where the moving centre's line passes outside the reach.
};
/// `apart`: from one centre to the other, metres; `drift`: how that changes, metres a second;
/// `reach`: the sum of the radii, metres.
inline Approach make_approach(Vec2 apart, Vec2 drift, double reach) noexcept {
  const double speed_squared = dot(drift, drift);
  // No difference of squares of distances here: a near miss is decided by how far the line passes.
  const double beside = cross(apart, drift);
  return {dot(apart, apart) - reach * reach, -dot(apart, drift), speed_squared,
          speed_squared * reach * reach - beside * beside};
}
/// Do the discs surely not touch within the horizon (seconds)? Has no branch: most pairs miss.
inline bool surely_miss(const Approach& approach, double horizon) noexcept {
  const bool is_apart = approach.beyond > 0;
  const bool is_slow = approach.beyond > 2 * horizon * approach.nearing;
  return is_apart & (is_slow | (approach.square < 0));
}

/// When the discs touch, whether or not a wall is between them. A graze counts. The result is the
/// same to the last bit whichever of the two comes first.
inline std::optional<Collision> contact(const Approach& approach, double horizon) noexcept {
  if (surely_miss(approach, horizon)) return {};
  const auto [beyond, nearing, speed_squared, square] = approach;
  const double root = std::sqrt(square > 0 ? square : 0.0);
  const double first = beyond > 0 ? beyond / (nearing + root) : 0;
  if (first > horizon) return {};
  const double last = speed_squared > 0 ? (nearing + root) / speed_squared : horizon;
  return Collision{first, std::min(std::max(last, first), horizon)};
}

}  // namespace docent::crowd
