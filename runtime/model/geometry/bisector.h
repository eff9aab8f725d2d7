#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/vec2.h"
#include "runtime/model/geometry/voronoi_diagram.h"

namespace docent {

/// The points equally far from a focus and a line (the directrix).
///
/// At signed distance u along the directrix from the foot of the focus it is (u^2 + p^2) / (2 p)
/// away from the directrix, p being the distance of the focus from it. That is its clearance too.
struct Parabola {
  Vec2 foot{};    ///< Of the perpendicular from the focus to the directrix.
  Vec2 along{};   ///< Unit vector of the directrix.
  Vec2 across{};  ///< Unit vector from the directrix to the focus.
  double p = 0;   ///< Metres, positive.
};

/// The parabola about a corner and a wall that does not end there.
inline Parabola make_parabola(Vec2 focus, Vec2 wall_start, Vec2 wall_end) noexcept {
  const Vec2 along = glm::normalize(wall_end - wall_start);
  const double height = cross(along, focus - wall_start);
  const Vec2 across = height < 0 ? -left_of(along) : left_of(along);
  return {focus - std::abs(height) * across, along, across, std::abs(height)};
}

inline double parameter_at(const Parabola& parabola, Vec2 point) noexcept {
  return dot(point - parabola.foot, parabola.along);
}
inline double clearance_at(const Parabola& parabola, double u) noexcept {
  return (u * u + parabola.p * parabola.p) / (2 * parabola.p);
}
inline Vec2 point_at(const Parabola& parabola, double u) noexcept {
  return parabola.foot + u * parabola.along + clearance_at(parabola, u) * parabola.across;
}

/// Length of the arc between two parameters: the integral of sqrt(1 + (u / p)^2).
inline double arc_length(const Parabola& parabola, double from, double to) noexcept {
  const auto primitive = [p = parabola.p](double u) {
    const double s = u / p;
    return p / 2 * (s * std::hypot(1.0, s) + std::asinh(s));
  };
  return std::abs(primitive(to) - primitive(from));
}

/// Where the tangents at two parameters meet: the middle control point of the quadratic Bezier
/// curve that is this arc exactly.
inline Vec2 control_point(const Parabola& parabola, double from, double to) noexcept {
  const double height = (from * to + parabola.p * parabola.p) / (2 * parabola.p);
  return parabola.foot + (from + to) / 2 * parabola.along + height * parabola.across;
}

/// The parabola of a Voronoi edge that is an arc of one.
inline Parabola parabola_of(const FloorPlan& plan, const VoronoiDiagram& diagram,
                            const VoronoiEdge& edge) noexcept {
  const Site left = diagram.site[edge.left], right = diagram.site[edge.right];
  const auto [corner, wall] =
      left.kind == Site::Kind::Corner ? std::pair(left, right) : std::pair(right, left);
  return make_parabola(plan.vertex[corner.index], wall_start(plan, wall.index),
                       wall_end(plan, wall.index));
}

/// Metres along a Voronoi edge.
inline double length_of(const FloorPlan& plan, const VoronoiDiagram& diagram,
                        const VoronoiEdge& edge) noexcept {
  const Vec2 from = diagram.vertex[edge.from], to = diagram.vertex[edge.to];
  if (!edge.parabola) return glm::distance(from, to);
  const Parabola parabola = parabola_of(plan, diagram, edge);
  return arc_length(parabola, parameter_at(parabola, from), parameter_at(parabola, to));
}

/// The smallest clearance along a Voronoi edge, metres: at an end, or where the edge passes
/// straight between its two sites, of which at least one is a corner then.
inline double least_clearance(const FloorPlan& plan, const VoronoiDiagram& diagram,
                              const VoronoiEdge& edge) noexcept {
  const Vec2 from = diagram.vertex[edge.from], to = diagram.vertex[edge.to];
  const double at_ends = std::min(diagram.clearance[edge.from], diagram.clearance[edge.to]);
  if (edge.parabola) {
    const Parabola parabola = parabola_of(plan, diagram, edge);
    const bool has_apex = parameter_at(parabola, from) * parameter_at(parabola, to) < 0;
    return has_apex ? std::min(at_ends, parabola.p / 2) : at_ends;
  }
  const Site left = diagram.site[edge.left], right = diagram.site[edge.right];
  if (left.kind != Site::Kind::Corner || right.kind != Site::Kind::Corner) return at_ends;
  const Vec2 a = plan.vertex[left.index], b = plan.vertex[right.index];
  const Vec2 middle = (a + b) / 2.0;
  const bool passes_between = dot(middle - from, to - from) > 0 && dot(middle - to, from - to) > 0;
  return passes_between ? std::min(at_ends, glm::distance(a, b) / 2) : at_ends;
}

}  // namespace docent
