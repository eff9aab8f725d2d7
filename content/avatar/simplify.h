#pragma once

#include "content/avatar/surface_nets.h"

namespace docent::avatar {

/// Bends upright limbs to waves, so that no edge along them becomes longer than about `edge` metres
/// where `error` is allowed: a straight trouser leg needs vertices where the knee will bend it.
std::function<Vec3(Vec3)> wavy(float edge, float error);

/// How far a surface may be simplified: until one of these would be broken.
struct SimplifyLimits {
  std::size_t triangles = 0;  ///< No fewer than that are made.
  float error = 0.001F;       ///< Metres from the surface as it was.
  /// Where a place is for the measure of errors: what this magnifies is kept finer, and a straight
  /// limb that it bends is divided. Empty: where it is.
  std::function<Vec3(Vec3)> lens{};
};

/// Collapses edges, cheapest first (meshoptimizer: Garland and Heckbert 1997, quadric error
/// metrics). A closed surface stays closed and of the same topology; an open border stays where it
/// is. Vertices stay where they are, those that are left over are dropped. Deterministic.
void simplify(TriangleSurface& surface, const SimplifyLimits& limits);

}  // namespace docent::avatar
