#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::floor {

/// Which part of the plane rings enclose.
enum class Fill : std::uint8_t {
  /// The union over all polygons of what the outer ring winds about and no hole of it does.
  Polygons,
  /// What the rings together wind about counter-clockwise: rings that are walls already.
  LeftOfRings,
};

/// A closed ring of at least three vertices, no two consecutive ones equal.
struct OverlayRing {
  std::vector<Vec2> vertex;
  std::uint32_t polygon = 0;  ///< The one it belongs to; unused with Fill::LeftOfRings.
  bool hole = false;
};

/// Two rings (or one, with itself) that cross, touch or run along each other.
struct RingContact {
  std::uint32_t a = 0, b = 0;  ///< Indices of the rings, a <= b.
  Vec2 at{};                   ///< The first such point, from west to east.
  bool crossing = false;       ///< Some of their common points are vertices of neither.
};

/// The subdivision of the plane by a set of rings.
struct RingOverlay {
  /// The boundary of the enclosed part, which lies on its left. Every vertex belongs to one wedge
  /// of it, so a ring touches itself, instead of crossing, where two wedges share a point. A ring
  /// begins with the vertex that comes first in the input; rings are in the order of those.
  std::vector<std::vector<Vec2>> walls;
  std::vector<RingContact> contacts;     ///< One per pair of rings, in order.
  std::vector<std::uint8_t> bounds_any;  ///< Per ring: is a piece of it part of a wall?
  bool adds_vertices = false;            ///< A wall has a vertex that no ring has.
};

/// Computes it exactly (CGAL, 2D arrangements); only new vertices are rounded, once each, to the
/// nearest doubles. Vertices of `rings` come through bit for bit, but for those on a straight wall,
/// exactly or to within a rounding error, which are dropped.
RingOverlay overlay(std::span<const OverlayRing> rings, Fill fill);

}  // namespace docent::floor
