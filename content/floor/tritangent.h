#pragma once

#include <array>

#include "runtime/model/geometry/vec2.h"

namespace docent::floor {

/// A wall or a corner, as a disc may touch it.
struct TangentSite {
  bool is_wall = false;
  Vec2 a{}, b{};  ///< A wall's ends, the open side on its left; a corner is `a` alone.
};

/// A disc that touches three sites from the open side.
struct TritangentDisc {
  Vec2 centre{};
  /// Metres. Negative when the disc touches its walls from behind instead: then the centre is a
  /// Voronoi vertex outside the floor. Zero at a corner between two of the sites. Anything, even
  /// infinite or not a number, where the sites are three walls on one line, or all but.
  double radius = 0;
};

/// The disc that touches the sites in this counter-clockwise order and holds none of them, as CGAL
/// numbers the sites of a Voronoi vertex. Computed in long double about a point near it and rounded
/// once. Three corners give a positive radius.
///
/// The unknowns are x, y and the signed radius r. A wall with left normal n gives in their space
/// the plane dot(n, (x, y)) - r = const, a corner gives a cone, two corners the plane between them.
/// So all but one of the equations are planes, and the last is a plane or a quadratic equation. A
/// wall next to its own corner, and two walls that share one, are nearly parallel where the corner
/// is flat; they are replaced by the line that the disc's centre must lie on, which is known
/// exactly.
TritangentDisc tritangent_disc(const std::array<TangentSite, 3>& sites);

}  // namespace docent::floor
