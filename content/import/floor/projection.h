#pragma once

#include "runtime/model/geometry/vec2.h"

namespace docent::import {

/// Lays longitude and latitude flat about an origin, keeping angles: a transverse Mercator map of
/// the WGS84 ellipsoid to third order. Within 2 km of the origin a point is right to 1 mm; lengths
/// are right to 1e-7.
///
/// With n the ellipsoid's radius across the meridian, l the longitude from the origin, A = l
/// cos(lat), T = tan(lat)^2 and C = e'^2 cos(lat)^2: x = n (A + (1 - T + C) A^3 / 6) and y =
/// meridian arc + n tan(lat) A^2 / 2 (Snyder, Map Projections - A Working Manual, 1987, equations
/// 8-9 and 8-10).
class LocalProjection {
 public:
  /// `origin_degrees`: longitude, then latitude; it becomes (0, 0).
  explicit LocalProjection(Vec2 origin_degrees);

  /// Degrees, longitude then latitude, to metres east and north of the origin.
  [[nodiscard]] Vec2 to_floor(Vec2 degrees) const noexcept;

 private:
  Vec2 origin_;  ///< Radians.
};

}  // namespace docent::import
