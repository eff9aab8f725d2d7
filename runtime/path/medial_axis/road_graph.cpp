#include "runtime/path/medial_axis/road_graph.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <ranges>
#include <utility>

#include "runtime/model/none.h"
#include "runtime/path/flatten.h"
#include "runtime/path/index/list_edges.h"

namespace docent::path {
namespace {}  // namespace

RoadGraph::RoadGraph(const Roadmap& roadmap, std::span<const EdgeCurve> curve)
    : roadmap_(&roadmap), curve_(curve) {
  find_junctions();
  list_roads();
  grow_widest_tree();
  measure_landmarks();
}

void RoadGraph::find_junctions() {
  const auto& edges = roadmap_->edges;
  const std::size_t nodes = roadmap_->position.size();
  std::vector<std::uint32_t> first, at;
  list_edges(
      nodes, edges.size(), [&](std::uint32_t e) { return std::array{edges[e].from, edges[e].to}; },
      first, at);
  edge_step_.assign(edges.size(), none);
  node_place_.resize(nodes);
  const auto make_junction = [&](std::uint32_t node) {
    node_place_[node].junction = static_cast<std::uint32_t>(junction_node_.size());
    junction_node_.push_back(node);
  };
  const auto follow_all = [&](std::uint32_t node) {
    for (std::uint32_t k = first[node]; k < first[node + 1]; ++k)
      if (edge_step_[at[k]] == none) follow(node, at[k], first, at);
  };
  for (std::uint32_t node = 0; node < nodes; ++node)
    if (first[node + 1] - first[node] != 2) make_junction(node);
  for (std::uint32_t node = 0; node < nodes; ++node)
    if (node_place_[node].junction != none) follow_all(node);
  for (std::uint32_t node = 0; node < nodes; ++node)  // What is left are loops.
    if (first[node + 1] - first[node] == 2 && edge_step_[at[first[node]]] == none) {
      make_junction(node);
      follow_all(node);
    }
}

/// Makes the road that leaves a junction by an edge.
void RoadGraph::follow(std::uint32_t node, std::uint32_t edge,
                       const std::vector<std::uint32_t>& first,
                       const std::vector<std::uint32_t>& edges) {
  const std::uint32_t start = node;
  Road road{.from = node_place_[start].junction,
            .first_step = static_cast<std::uint32_t>(step_.size())};
  for (;;) {
    const RoadmapEdge& next = roadmap_->edges[edge];
    const bool forward = next.from == node;
    const EdgeCurve& curve = curve_[next.voronoi_edge];
    edge_step_[edge] = static_cast<std::uint32_t>(step_.size());
    step_.push_back({.edge = edge,
                     .road = static_cast<std::uint32_t>(road_.size()),
                     .begin = forward ? curve.begin() : curve.end(),
                     .end = forward ? curve.end() : curve.begin()});
    node = forward ? next.to : next.from;
    if (node_place_[node].junction != none) break;
    node_place_[node] = {edge_step_[edge], step_.back().end, none};
    edge = edges[first[node]] == edge ? edges[first[node] + 1] : edges[first[node]];
  }
  road.to = node_place_[node].junction;
  road.steps = static_cast<std::uint32_t>(step_.size()) - road.first_step;
  finish_road(road);
}

/// Sums up and flattens the steps of a road.
void RoadGraph::finish_road(Road road) {
  const auto steps = std::span(step_).subspan(road.first_step, road.steps);
  road.clearance = infinity;
  for (Step& step : steps) {
    const RoadmapEdge& edge = roadmap_->edges[step.edge];
    step.before = road.length;
    step.clearance_before = road.clearance;
    road.length += edge.length;
    road.clearance = std::min(road.clearance, edge.clearance);
    road.greatest_clearance = std::max(
        {road.greatest_clearance, roadmap_->clearance[edge.from], roadmap_->clearance[edge.to]});
    // Ends are the nodes' own points, so that steps fit without a seam.
    const bool forward = step.begin == curve_of(step).begin();
    step.first_point = static_cast<std::uint32_t>(point_.size());
    point_.push_back(roadmap_->position[forward ? edge.from : edge.to]);
    curve_of(step).append_inner_points(step.begin, step.end, point_);
    step.end_point = static_cast<std::uint32_t>(point_.size());
  }
  point_.push_back(position(road.to));
  double after = infinity;
  for (std::size_t i = steps.size(); i-- > 0;) {
    steps[i].clearance_after = after;
    after = std::min(after, roadmap_->edges[steps[i].edge].clearance);
  }
  road_.push_back(road);
}

void RoadGraph::list_roads() {
  list_edges(
      junctions(), 2 * road_.size(),
      [&](std::uint32_t way) {
        const Road& road = road_[way / 2];
        return std::array{way % 2 == 0 ? road.from : road.to, none};
      },
      junction_first_, junction_road_);
}

/// Kruskal's rule, widest road first; sets are joined by size, and links are never shortened. The
/// narrowest link between two junctions is then the narrowest road between them on a maximum
/// spanning tree, so on the widest way.
void RoadGraph::grow_widest_tree() {
  std::vector<std::uint32_t> order(road_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::greater{},
                           [&](std::uint32_t road) { return road_[road].clearance; });
  joined_to_.resize(junctions());
  std::iota(joined_to_.begin(), joined_to_.end(), 0U);
  joined_by_.assign(junctions(), -1);
  std::vector<std::uint32_t> size(junctions(), 1);
  const auto root_of = [&](std::uint32_t junction) {
    while (joined_to_[junction] != junction) junction = joined_to_[junction];
    return junction;
  };
  for (const std::uint32_t road : order) {
    std::uint32_t small = root_of(road_[road].from), large = root_of(road_[road].to);
    if (small == large) continue;
    if (size[small] > size[large]) std::swap(small, large);
    size[large] += size[small];
    joined_to_[small] = large;
    joined_by_[small] = road_[road].clearance;
  }
}

double RoadGraph::widest(std::uint32_t from, std::uint32_t to) const noexcept {
  double narrowest = infinity;
  while (from != to) {
    // The link made first is followed first; roots have none.
    if (joined_by_[from] < joined_by_[to]) std::swap(from, to);
    if (joined_to_[from] == from) return -1;
    narrowest = std::min(narrowest, joined_by_[from]);
    from = joined_to_[from];
  }
  return narrowest;
}

std::vector<double> RoadGraph::distances_from(std::uint32_t junction) const {
  std::vector<double> distance(junctions(), infinity);
  std::vector<std::pair<double, std::uint32_t>> queue{{0.0, junction}};
  distance[junction] = 0;
  while (!queue.empty()) {
    std::ranges::pop_heap(queue, std::greater{});
    const auto [length, at] = queue.back();
    queue.pop_back();
    if (length > distance[at]) continue;
    for (const std::uint32_t way : roads_at(at)) {
      const Road& road = road_[way / 2];
      const std::uint32_t other = way % 2 == 0 ? road.to : road.from;
      if (length + road.length >= distance[other]) continue;
      distance[other] = length + road.length;
      queue.emplace_back(distance[other], other);
      std::ranges::push_heap(queue, std::greater{});
    }
  }
  return distance;
}

/// Each landmark is the junction farthest from those before it, and of a part of the floor that has
/// none yet before all others.
void RoadGraph::measure_landmarks() {
  distance_.assign(junctions(), Distances{});
  if (junctions() == 0) return;
  std::vector<double> nearest = distances_from(0);
  for (std::size_t i = 0; i < landmarks; ++i) {
    const auto farthest =
        static_cast<std::uint32_t>(std::ranges::max_element(nearest) - nearest.begin());
    const std::vector<double> distance = distances_from(farthest);
    for (std::size_t j = 0; j < junctions(); ++j) {
      if (distance[j] == infinity) continue;
      distance_[j][i] = distance[j];
      nearest[j] = i == 0 ? distance[j] : std::min(nearest[j], distance[j]);
    }
  }
}

RoadGraph::Distances RoadGraph::distances_of(const Place& place) const noexcept {
  Distances least;
  least.fill(infinity);
  for (const Exit& exit : exits_of(place)) {
    if (exit.junction == none) continue;
    for (std::size_t i = 0; i < landmarks; ++i)
      least[i] = std::min(least[i], exit.length + distance_[exit.junction][i]);
  }
  return least;
}

double RoadGraph::least_distance(std::uint32_t junction, const Distances& to) const noexcept {
  double least = 0;
  for (std::size_t i = 0; i < landmarks; ++i)
    least = std::max(least, std::abs(distance_[junction][i] - to[i]));
  return least;
}

Vec2 RoadGraph::point_at(const Place& place) const noexcept {
  if (place.step == none) return position(place.junction);
  const Step& step = step_[place.step];
  if (place.at == step.begin) return point_[step.first_point];
  if (place.at == step.end) return point_[step.end_point];
  return curve_of(step).point_at(place.at);
}

std::array<RoadGraph::Exit, 2> RoadGraph::exits_of(const Place& place) const noexcept {
  if (place.step == none) return {Exit{place.junction}, Exit{}};
  const Step& step = step_[place.step];
  const Road& road = road_[step.road];
  const EdgeCurve& curve = curve_of(step);
  const double before = step.before + curve.length_between(step.begin, place.at);
  return {Exit{road.from, before,
               std::min(step.clearance_before, curve.clearance_between(step.begin, place.at))},
          Exit{road.to, std::max(0.0, road.length - before),
               std::min(step.clearance_after, curve.clearance_between(place.at, step.end))}};
}

std::optional<RoadGraph::Between> RoadGraph::between(const Place& from,
                                                     const Place& to) const noexcept {
  if (from.step == none || to.step == none || road_of(from) != road_of(to)) return {};
  if (from.step > to.step) return between(to, from);
  const Step &first = step_[from.step], &last = step_[to.step];
  if (from.step == to.step)
    return Between{curve_of(first).length_between(from.at, to.at),
                   curve_of(first).clearance_between(from.at, to.at)};
  double clearance = std::min(curve_of(first).clearance_between(from.at, first.end),
                              curve_of(last).clearance_between(last.begin, to.at));
  for (std::uint32_t s = from.step + 1; s < to.step; ++s)
    clearance = std::min(clearance, roadmap_->edges[step_[s].edge].clearance);
  const double rest = curve_of(first).length_between(from.at, first.end);
  const double inner = last.before - step_[from.step + 1].before;
  return Between{rest + inner + curve_of(last).length_between(last.begin, to.at), clearance};
}

void RoadGraph::append_between(const Place& from, const Place& to,
                               std::vector<Vec2>& points) const {
  const Step &first = step_[from.step], &last = step_[to.step];
  const bool backwards =
      from.step == to.step ? (to.at - from.at) * (last.end - last.begin) < 0 : from.step > to.step;
  if (backwards) {
    std::vector<Vec2> onwards;
    append_between(to, from, onwards);
    for (const Vec2 point : std::views::reverse(onwards)) append_point(point, points);
    return;
  }
  append_point(point_at(from), points);
  if (from.step == to.step) {
    curve_of(first).append_inner_points(from.at, to.at, points);
  } else {
    curve_of(first).append_inner_points(from.at, first.end, points);
    for (std::uint32_t i = first.end_point; i <= last.first_point; ++i)
      append_point(point_[i], points);
    curve_of(last).append_inner_points(last.begin, to.at, points);
  }
  append_point(point_at(to), points);
}

}  // namespace docent::path
