#include "runtime/path/medial_axis_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace docent {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Lists, for each of `count` things, the edges that end there.
template <class Ends>
void list_edges(std::size_t count, std::size_t edges, Ends ends, std::vector<std::uint32_t>& first,
                std::vector<std::uint32_t>& list) {
  first.assign(count + 1, 0);
  for (std::uint32_t e = 0; e < edges; ++e)
    for (const std::uint32_t end : ends(e))
      if (end < count) ++first[end + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  list.resize(first.back());
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  for (std::uint32_t e = 0; e < edges; ++e)
    for (const std::uint32_t end : ends(e))
      if (end < count) list[fill[end]++] = e;
}

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

}  // namespace

MedialAxisMap::MedialAxisMap(const Floor& floor) : floor_(&floor) {
  const VoronoiDiagram& voronoi = floor.diagram;
  curve_.reserve(voronoi.edge.size());
  for (const VoronoiEdge& edge : voronoi.edge) curve_.emplace_back(floor.plan, voronoi, edge);
  const auto& edges = floor.roadmap.edges;
  list_edges(
      floor.roadmap.position.size(), edges.size(),
      [&](std::uint32_t e) { return std::array{edges[e].from, edges[e].to}; }, node_first_,
      node_edge_);
  vertex_node_.assign(voronoi.vertex.size(), none);
  for (std::uint32_t node = 0; node < floor.roadmap.voronoi_vertex.size(); ++node)
    vertex_node_[floor.roadmap.voronoi_vertex[node]] = node;
  edge_roadmap_.assign(voronoi.edge.size(), none);
  for (std::uint32_t e = 0; e < edges.size(); ++e) edge_roadmap_[edges[e].voronoi_edge] = e;
  lead_to_road();
}

/// Spreads from the nodes over the axis edges that the roadmap leaves out, breadth first.
void MedialAxisMap::lead_to_road() {
  const VoronoiDiagram& voronoi = floor_->diagram;
  std::vector<std::uint32_t> first, edges;
  list_edges(
      voronoi.vertex.size(), voronoi.edge.size(),
      [&](std::uint32_t e) {
        const VoronoiEdge& edge = voronoi.edge[e];
        return edge.on_medial_axis ? std::array{edge.from, edge.to} : std::array{none, none};
      },
      first, edges);
  edge_to_road_.assign(voronoi.vertex.size(), none);
  std::vector<std::uint32_t> reached = floor_->roadmap.voronoi_vertex;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const std::uint32_t vertex = reached[i];
    for (std::uint32_t k = first[vertex]; k < first[vertex + 1]; ++k) {
      const VoronoiEdge& edge = voronoi.edge[edges[k]];
      const std::uint32_t other = edge.from == vertex ? edge.to : edge.from;
      if (vertex_node_[other] != none || edge_to_road_[other] != none) continue;
      edge_to_road_[other] = edges[k];
      reached.push_back(other);
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
    foot = a + std::clamp(dot(point - a, along), 0.0, dot(b - a, along)) * along;
  } else {
    foot = plan.vertex[below.index];
    const double distance = glm::length(point - foot);
    if (!(distance > 0)) return {};
    up = (point - foot) / distance;
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

}  // namespace docent
