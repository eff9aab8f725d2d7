#include "runtime/path/medial_axis/medial_axis_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/model/geometry/segment.h"
#include "runtime/model/none.h"
#include "runtime/path/index/list_edges.h"

namespace docent::path {
namespace {

/// How far along the ray from `foot` in the unit direction `n` another site is as near as the foot,
/// or infinity.
double meets(Vec2 foot, Vec2 n, const FloorPlan& plan, Site other) {
  if (other.kind == Site::Kind::Corner) {
    const Vec2 to = plan.vertex[other.index] - foot;
    const double towards = dot(n, to);
    return towards > 0 ? dot(to, to) / (2 * towards) : infinity;
  }
  const Vec2 a = wall_start(plan, other.index), b = wall_end(plan, other.index);
  const Vec2 along = glm::normalize(b - a), inward = left_of(along);
  const double against = 1 - dot(inward, n);
  if (against <= 0) return infinity;
  const double distance = dot(inward, foot - a) / against;
  const double at = dot(foot + distance * n - a, along), length = dot(b - a, along);
  constexpr double slack = 1e-6;  // metres; the regions' ends are the corners' business
  return distance >= 0 && at >= -slack && at <= length + slack ? distance : infinity;
}

std::vector<EdgeCurve> curves_of(const Floor& floor) {
  std::vector<EdgeCurve> curves;
  curves.reserve(floor.diagram.edge.size());
  for (const VoronoiEdge& edge : floor.diagram.edge)
    curves.emplace_back(floor.plan, floor.diagram, edge);
  return curves;
}

}  // namespace

MedialAxisMap::MedialAxisMap(const Floor& floor)
    : floor_(&floor), curve_(curves_of(floor)), roads_(floor.roadmap, curve_) {
  const VoronoiDiagram& voronoi = floor.diagram;
  const auto& edges = floor.roadmap.edges;
  vertex_node_.assign(voronoi.vertex.size(), none);
  for (std::uint32_t node = 0; node < floor.roadmap.voronoi_vertex.size(); ++node)
    vertex_node_[floor.roadmap.voronoi_vertex[node]] = node;
  edge_roadmap_.assign(voronoi.edge.size(), none);
  for (std::uint32_t e = 0; e < edges.size(); ++e) edge_roadmap_[edges[e].voronoi_edge] = e;
  list_edges(
      voronoi.vertex.size(), voronoi.edge.size(),
      [&](std::uint32_t e) {
        const VoronoiEdge& edge = voronoi.edge[e];
        return edge.on_medial_axis ? std::array{edge.from, edge.to} : std::array{none, none};
      },
      axis_first_, axis_edge_);
  lead_to_road();
  spread_roads();
  follow_regions();
}

void MedialAxisMap::follow_regions() {
  const VoronoiDiagram& voronoi = floor_->diagram;
  const FloorPlan& plan = floor_->plan;
  left_place_.resize(voronoi.edge.size());
  right_place_.resize(voronoi.edge.size());
  for (std::uint32_t site = 0; site + 1 < voronoi.region_first.size(); ++site)
    for (std::uint32_t k = voronoi.region_first[site]; k < voronoi.region_first[site + 1]; ++k) {
      const std::uint32_t e = voronoi.region_edge[k];
      (voronoi.edge[e].left == site ? left_place_ : right_place_)[e] = k;
    }

  std::vector<std::uint32_t> previous(plan.vertex.size());
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) previous[plan.next[i]] = i;
  corner_.resize(voronoi.site.size());
  for (std::size_t s = 0; s < voronoi.site.size(); ++s) {
    const Site& site = voronoi.site[s];
    if (site.kind != Site::Kind::Corner) continue;
    // Straight, where obstacles share a corner: an arc without extent.
    const Vec2 place = plan.vertex[site.index];
    const ReflexCorner straight{site.index, place,
                                left_of(glm::normalize(wall_end(plan, site.index) - place)), 0};
    corner_[s] = reflex_corner(plan, previous[site.index], site.index).value_or(straight);
  }

  clearance_.reserve(curve_.size());
  for (std::uint32_t e = 0; e < curve_.size(); ++e) {
    const double from = voronoi.clearance[voronoi.edge[e].from];
    const double to = voronoi.clearance[voronoi.edge[e].to];
    const double lowest = curve_[e].clearance_at(curve_[e].lowest_place());
    clearance_.push_back({std::min({from, to, lowest}), std::max(from, to)});
  }
  by_clearance_ = IntervalTree(clearance_);
}

void MedialAxisMap::spread_roads() {
  const Roadmap& roadmap = floor_->roadmap;
  std::vector<Box> boxes;
  std::vector<bool> has_edge(roadmap.position.size(), false);
  for (const RoadmapEdge& edge : roadmap.edges) {
    const EdgeCurve& curve = curve_[edge.voronoi_edge];
    boxes.push_back({curve.low(), curve.high()});
    has_edge[edge.from] = has_edge[edge.to] = true;
  }
  for (std::uint32_t node = 0; node < has_edge.size(); ++node) {
    if (has_edge[node]) continue;
    lone_node_.push_back(node);
    boxes.push_back({roadmap.position[node], roadmap.position[node]});
  }
  road_tree_ = BoxTree(boxes);
}

RoadGraph::Place MedialAxisMap::nearest_place(std::uint32_t thing, Vec2 point) const {
  const auto& edges = floor_->roadmap.edges;
  if (thing >= edges.size()) return roads_.place_at(lone_node_[thing - edges.size()]);
  return roads_.place_on(thing, curve_[edges[thing].voronoi_edge].nearest_place(point));
}

/// Spreads from the nodes over the axis edges that the roadmap leaves out, breadth first; over a
/// place where obstacles touch, which only a point can pass, to what has no other way.
void MedialAxisMap::lead_to_road() {
  const VoronoiDiagram& voronoi = floor_->diagram;
  edge_to_road_.assign(voronoi.vertex.size(), none);
  std::vector<std::uint32_t> reached = floor_->roadmap.voronoi_vertex, where_walls_touch;
  for (std::size_t i = 0; i < reached.size() || !where_walls_touch.empty(); ++i) {
    if (i == reached.size()) {
      reached.push_back(where_walls_touch.back());
      where_walls_touch.pop_back();
    }
    const std::uint32_t vertex = reached[i];
    for (const std::uint32_t e : axis_edges_at(vertex)) {
      const VoronoiEdge& edge = voronoi.edge[e];
      const std::uint32_t other = edge.from == vertex ? edge.to : edge.from;
      if (vertex_node_[other] != none || edge_to_road_[other] != none) continue;
      edge_to_road_[other] = e;
      (voronoi.clearance[other] > 0 ? reached : where_walls_touch).push_back(other);
    }
  }
}

std::optional<MedialAxisMap::Place> MedialAxisMap::place_above(std::uint32_t site,
                                                               Vec2 point) const {
  const VoronoiDiagram& voronoi = floor_->diagram;
  const FloorPlan& plan = floor_->plan;
  if (site + 1 >= voronoi.region_first.size()) return {};

  Vec2 foot, up;
  const Site& below = voronoi.site[site];
  if (below.kind == Site::Kind::Wall) {
    const Vec2 a = wall_start(plan, below.index), b = wall_end(plan, below.index);
    const Vec2 along = glm::normalize(b - a);
    up = left_of(along);
    foot = glm::mix(a, b, nearest_on_segment(point, a, b).t);
  } else {
    foot = plan.vertex[below.index];
    const double distance = glm::length(point - foot);
    if (distance > 0) {
      up = (point - foot) / distance;
    } else {  // In the corner itself, all directions between its walls' normals lead away from it.
      const Vec2 begin = left_of(glm::normalize(wall_end(plan, below.index) - foot));
      const double half = corner_[site].extent / 2;
      up = std::cos(half) * begin + std::sin(half) * left_of(begin);
    }
  }

  const std::span region = std::span(voronoi.region_edge)
                               .subspan(voronoi.region_first[site], voronoi.region_first[site + 1] -
                                                                        voronoi.region_first[site]);
  double height = infinity;
  for (const std::uint32_t e : region) {
    const VoronoiEdge& edge = voronoi.edge[e];
    if (!edge.on_medial_axis) continue;
    const std::uint32_t other = edge.left == site ? edge.right : edge.left;
    height = std::min(height, meets(foot, up, plan, voronoi.site[other]));
  }
  if (!std::isfinite(height)) return {};

  const Vec2 top = foot + height * up;
  std::optional<Place> best;
  double best_squared = infinity;
  for (const std::uint32_t e : region) {
    if (!voronoi.edge[e].on_medial_axis) continue;
    const double at = curve_[e].nearest_place(top);
    const Vec2 apart = curve_[e].point_at(at) - top;
    if (dot(apart, apart) >= best_squared) continue;
    best_squared = dot(apart, apart);
    best = Place{e, at};
  }
  return best;
}

}  // namespace docent::path
