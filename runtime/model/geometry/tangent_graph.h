#pragma once

#include <cstdint>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// A part of the circle about a reflex corner along which the centre of a disc can go: no point of
/// it is so near to a wall that the disc does not fit.
///
/// Angles are measured from the normal of the wall that begins at the corner, counter-clockwise,
/// and reach at most pi (the normal of the wall that ends there).
struct TangentArc {
  std::uint32_t vertex = 0;   ///< The reflex corner: a vertex of the FloorPlan.
  double begin = 0, end = 0;  ///< Radians, 0 <= begin <= end < pi, also where the radius is 0.
};

/// A straight way from one arc to another, tangent to both circles and clear of every wall. It is
/// directed: the way back is a tangent of its own.
struct Tangent {
  Vec2 leave{};             ///< Where it leaves the circle of its own side.
  double leave_angle = 0;   ///< Radians: of that point, on the arc of its own side.
  double arrive_angle = 0;  ///< Radians: of its other end, on the arc of `arrive_side`.
  double length = 0;        ///< Metres.
  std::uint32_t arrive_side = 0;
  std::uint32_t onward = 0;  ///< The first tangent that leaves `arrive_side` at or after the
                             ///< arrival, or no_tangent.
};

/// All shortest ways of a disc of one radius bend only on circles about reflex corners and run
/// straight between them: this graph holds every arc and every tangent that such a way can use.
///
/// Frame: floor. Each arc has two sides, one per sense of going round it: side 2a is arc a
/// counter-clockwise, side 2a + 1 clockwise. The tangents that leave side s are
/// tangent[side_first[s] .. side_first[s + 1]), in the order in which the way meets them, so a way
/// that arrives takes `onward` or any later tangent of that side. side_first has
/// 2 * arc.size() + 1 entries. Depends only on the plan and the radius. Immutable once loaded.
struct TangentGraph {
  static constexpr std::uint32_t no_tangent = 0xffffffff;
  /// Metres, of the disc; the circles are smaller by the hair that a disc may lack where it fits.
  /// 0: arcs are points, and the graph is the taut visibility graph.
  double radius = 0;
  std::vector<TangentArc> arc{};
  std::vector<std::uint32_t> side_first{};
  std::vector<Tangent> tangent{};
};

}  // namespace docent
