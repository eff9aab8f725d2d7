#pragma once

#include <cstdint>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// A straight way between two corners' circles, tangent to both and clear of every wall by the
/// radius.
struct Tangent {
  std::uint32_t from = 0, to = 0;                ///< Corners: indices into TangentGraph::corner.
  Vec2 leave{}, arrive{};                        ///< Where it touches the circles.
  double leave_angle = 0, arrive_angle = 0;      ///< Radians, of those points about their corners.
  bool leaves_ccw = false, arrives_ccw = false;  ///< Sense in which the way goes round each corner.
};

/// All shortest ways of a disc of one radius bend only on circles about reflex corners and are
/// tangent to them: this graph holds those corners and the tangents between them. Frame: floor.
/// Immutable once loaded.
struct TangentGraph {
  double radius = 0;                  ///< Metres.
  std::vector<std::uint32_t> corner;  ///< Vertices of the FloorPlan that are reflex.
  std::vector<Tangent> tangents;
};

}  // namespace docent
