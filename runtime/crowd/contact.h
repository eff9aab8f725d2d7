#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/model/geometry/vec2.h"

/// When two moving discs touch: the one kernel of detection and of planning.
namespace docent::crowd {

/// From when to when two discs overlap or touch if both keep their velocity; seconds from now.
struct Collision {
  double first = 0;  ///< 0 where they touch already.
  double last = 0;   ///< At most the horizon.
};

/// Two discs as one that comes towards the other, which stands.
struct Approach {
  double beyond = 0;   ///< Distance squared less reach squared: positive where they are apart.
  double nearing = 0;  ///< Half of how fast the squared distance falls.
  double speed_squared = 0;
  double square = 0;  ///< Negative where the line of the drift passes outside of the reach.
};
/// `apart`: from one centre to the other; `drift`: how that changes a second; `reach`: both radii.
inline Approach make_approach(Vec2 apart, Vec2 drift, double reach) noexcept {
  const double speed_squared = dot(drift, drift);
  // No difference of squares of distances here: a near miss is decided by how far the line passes.
  const double beside = cross(apart, drift);
  return {dot(apart, apart) - reach * reach, -dot(apart, drift), speed_squared,
          speed_squared * reach * reach - beside * beside};
}
/// Do the discs surely not touch within the horizon? Without a branch, since most do not.
inline bool surely_miss(const Approach& approach, double horizon) noexcept {
  const bool is_apart = approach.beyond > 0;
  const bool is_slow = approach.beyond > 2 * horizon * approach.nearing;
  return is_apart & (is_slow | (approach.square < 0));
}

/// When the discs touch, walls or no walls. Touching with no speed to spare counts. The same seen
/// from either, to the last bit.
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
