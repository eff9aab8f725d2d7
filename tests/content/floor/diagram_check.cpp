#include "tests/content/floor/diagram_check.h"

#include <fmt/core.h>

#include <cmath>

#include "runtime/model/geometry/bisector.h"
#include "tests/content/floor/plans.h"

namespace docent::test {
namespace {

/// A point of an edge, `t` from 0 at its start to 1 at its end.
Vec2 point_on(const FloorPlan& plan, const VoronoiDiagram& diagram, const VoronoiEdge& edge,
              double t) {
  const Vec2 from = diagram.vertex[edge.from], to = diagram.vertex[edge.to];
  if (!edge.parabola) return from + t * (to - from);
  const Parabola parabola = parabola_of(plan, diagram, edge);
  return point_at(parabola, std::lerp(parameter_at(parabola, from), parameter_at(parabola, to), t));
}

/// Half the integral of x dy - y dx along an edge: its part of an enclosed area.
double area_under(const FloorPlan& plan, const VoronoiDiagram& diagram, const VoronoiEdge& edge) {
  const Vec2 a = diagram.vertex[edge.from], b = diagram.vertex[edge.to];
  if (!edge.parabola) return cross(a, b) / 2;
  const Parabola parabola = parabola_of(plan, diagram, edge);
  const Vec2 c = control_point(parabola, parameter_at(parabola, a), parameter_at(parabola, b));
  return (cross(a, c) + cross(c, b)) / 3 + cross(a, b) / 6;
}

Complaint check_indices(const FloorPlan& plan, const VoronoiDiagram& diagram) {
  if (diagram.clearance.size() != diagram.vertex.size()) return "clearance is incomplete";
  if (diagram.region_first.size() != diagram.site.size() + 1) return "regions are incomplete";
  if (diagram.region_edge.size() != 2 * diagram.edge.size()) return "an edge has not two sides";
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i)
    if (diagram.site[i].kind != Site::Kind::Wall || diagram.site[i].index != i)
      return "site i is not wall i";
  return {};
}

Complaint check_vertices(const FloorPlan& plan, const VoronoiDiagram& diagram, double equal) {
  for (std::size_t v = 0; v < diagram.vertex.size(); ++v) {
    const double nearest = distance_to_nearest_wall(plan, diagram.vertex[v]);
    if (std::abs(nearest - diagram.clearance[v]) > equal)
      return fmt::format("vertex {} claims {} and is {} from a wall", v, diagram.clearance[v],
                         nearest);
    if (diagram.clearance[v] > equal && !is_inside(plan, diagram.vertex[v]))
      return fmt::format("vertex {} is outside", v);
  }
  return {};
}

Complaint check_edges(const FloorPlan& plan, const VoronoiDiagram& diagram, double equal) {
  for (std::size_t e = 0; e < diagram.edge.size(); ++e) {
    const VoronoiEdge& edge = diagram.edge[e];
    for (const double t : {0.0, 0.1, 0.5, 0.8, 1.0}) {
      const Vec2 point = point_on(plan, diagram, edge, t);
      const double left = distance_to_site(plan, diagram.site[edge.left], point);
      const double right = distance_to_site(plan, diagram.site[edge.right], point);
      const double nearest = distance_to_nearest_wall(plan, point);
      if (std::abs(left - right) > equal)
        return fmt::format("edge {} at {}: {} from one site, {} from the other", e, t, left, right);
      if (std::abs(left - nearest) > equal)
        return fmt::format("edge {} at {}: a wall is nearer, {} than {}", e, t, nearest, left);
      if (least_clearance(plan, diagram, edge) > nearest + equal)
        return fmt::format("edge {} at {}: clearance below the least", e, t);
    }
  }
  return {};
}

/// Follows the loop of each region and adds its area up.
Complaint check_regions(const FloorPlan& plan, const VoronoiDiagram& diagram) {
  double all = 0;
  for (std::uint32_t s = 0; s < diagram.site.size(); ++s) {
    const auto [kind, index] = diagram.site[s];
    const bool is_wall = kind == Site::Kind::Wall;
    Vec2 at = is_wall ? wall_end(plan, index) : plan.vertex[index];
    double area = is_wall ? cross(wall_start(plan, index), at) / 2 : 0;
    for (std::uint32_t i = diagram.region_first[s]; i < diagram.region_first[s + 1]; ++i) {
      const VoronoiEdge& edge = diagram.edge[diagram.region_edge[i]];
      const bool along = edge.left == s;
      if (!along && edge.right != s) return fmt::format("region {} lists another's edge", s);
      if (diagram.vertex[along ? edge.from : edge.to] != at)
        return fmt::format("the loop of region {} is broken", s);
      at = diagram.vertex[along ? edge.to : edge.from];
      area += (along ? 1 : -1) * area_under(plan, diagram, edge);
    }
    if (at != (is_wall ? wall_start(plan, index) : plan.vertex[index]))
      return fmt::format("the loop of region {} is open", s);
    if (area < -1e-9 * floor_area(plan)) return fmt::format("region {} is inside out", s);
    all += area;
  }
  if (std::abs(all - floor_area(plan)) > 1e-6)
    return fmt::format("the regions cover {} of {} square metres", all, floor_area(plan));
  return {};
}

/// About a point of the plan, where areas keep their digits; the differences are exact.
void move_near_origin(FloorPlan& plan, VoronoiDiagram& diagram) {
  const Vec2 origin = plan.vertex.front();
  for (Vec2& vertex : plan.vertex) vertex -= origin;
  for (Vec2& vertex : diagram.vertex) vertex -= origin;
}

}  // namespace

Complaint check(FloorPlan plan, VoronoiDiagram diagram, double at_vertices, double along_edges) {
  move_near_origin(plan, diagram);
  Complaint complaint = check_indices(plan, diagram);
  if (complaint.empty()) complaint = check_vertices(plan, diagram, at_vertices);
  if (complaint.empty()) complaint = check_edges(plan, diagram, along_edges);
  if (complaint.empty()) complaint = check_regions(plan, diagram);
  return complaint;
}

}  // namespace docent::test
