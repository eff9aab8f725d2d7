#pragma once

#include "content/avatar/surface_nets.h"

namespace docent::avatar {

/// How far a surface may be simplified.
struct SimplifyLimits {
  float error = 0.001F;  ///< Metres from the planes of the triangles that a vertex stands for.
  float edge = 0.05F;    ///< Metres: longest new edge, since bends and shades need vertices.
};

/// Collapses edges of a closed surface, cheapest first, while the limits allow (Garland and
/// Heckbert 1997, quadric error metrics). The surface stays closed and of the same topology;
/// normals are not kept. Deterministic.
void simplify(TriangleSurface& surface, const SimplifyLimits& limits);

}  // namespace docent::avatar
