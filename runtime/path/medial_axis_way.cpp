#include "runtime/path/medial_axis_way.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <ranges>

#include "runtime/path/flatten.h"

namespace docent {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t none = MedialAxisMap::none;

/// A place of the roadmap: on an edge, or at a node where that edge is none.
struct RoadPlace {
  std::uint32_t edge = none;
  double at = 0;
  std::uint32_t node = none;
};

/// How a query's end point gets to the roadmap.
struct Entry {
  RoadPlace place;
  std::vector<Vec2> points;  ///< From the end point to the place, both included.
  double length = 0;
  double clearance = 0;
};

Vec2 point_of(const MedialAxisMap& axis, const RoadPlace& place) {
  const Roadmap& roadmap = axis.roadmap();
  if (place.edge == none) return roadmap.position[place.node];
  return axis.curve_of(roadmap.edges[place.edge]).point_at(place.at);
}

/// Goes straight away from the nearest wall until the axis, and on along it to the roadmap where
/// that leaves this part of the axis out.
std::optional<Entry> climb(const FloorMap& map, Vec2 point) {
  const MedialAxisMap& axis = map.medial_axis();
  const auto place = axis.place_above(map.site_at(point), point);
  if (!place) return {};
  const VoronoiDiagram& voronoi = axis.diagram();
  Entry entry{{}, {point}, 0, map.clearance_at(point)};
  std::uint32_t edge = place->voronoi_edge;
  double at = place->at;
  const Vec2 reached = axis.curve(edge).point_at(at);
  entry.length = glm::length(reached - point);
  append_point(reached, entry.points);
  if (axis.roadmap_edge(edge) != none) {
    entry.place = {axis.roadmap_edge(edge), at, none};
    return entry;
  }
  // Of the two ends, the road lies beyond the one that does not lead back over this edge.
  bool forward = axis.edge_to_road(voronoi.edge[edge].to) != edge;
  for (;;) {
    const EdgeCurve& curve = axis.curve(edge);
    const double end = forward ? curve.end() : curve.begin();
    entry.length += curve.length_between(at, end);
    entry.clearance = std::min(entry.clearance, curve.clearance_between(at, end));
    curve.append_points(at, end, entry.points);
    const std::uint32_t vertex = forward ? voronoi.edge[edge].to : voronoi.edge[edge].from;
    if (axis.node_at(vertex) != none) {
      entry.place = {none, 0, axis.node_at(vertex)};
      return entry;
    }
    edge = axis.edge_to_road(vertex);
    if (edge == none) return {};
    forward = voronoi.edge[edge].from == vertex;
    at = forward ? axis.curve(edge).begin() : axis.curve(edge).end();
  }
}

/// A thing of the roadmap with how near it is, or may be.
struct Candidate {
  double distance_squared;
  RoadPlace place;
  bool exact;
  bool operator<(const Candidate& other) const noexcept {  // priority_queue keeps the largest
    if (distance_squared != other.distance_squared)
      return distance_squared > other.distance_squared;
    if (place.edge != other.place.edge) return place.edge > other.place.edge;
    return place.node > other.place.node;
  }
};

/// The nearest place of the roadmap that a straight line reaches which keeps the radius.
std::optional<Entry> nearest_entry(const FloorMap& map, Vec2 point, double radius) {
  const MedialAxisMap& axis = map.medial_axis();
  const Roadmap& roadmap = axis.roadmap();
  std::vector<Candidate> candidates;
  for (std::uint32_t e = 0; e < roadmap.edges.size(); ++e) {
    const EdgeCurve& curve = axis.curve_of(roadmap.edges[e]);
    const Vec2 apart = point - glm::clamp(point, curve.low(), curve.high());
    candidates.push_back({dot(apart, apart), {e, 0, none}, false});
  }
  for (std::uint32_t n = 0; n < roadmap.position.size(); ++n)
    if (axis.edges_at(n).empty()) {
      const Vec2 apart = point - roadmap.position[n];
      candidates.push_back({dot(apart, apart), {none, 0, n}, true});
    }
  std::priority_queue<Candidate> queue({}, std::move(candidates));
  for (; !queue.empty();) {
    Candidate nearest = queue.top();
    queue.pop();
    if (!nearest.exact) {
      const EdgeCurve& curve = axis.curve_of(roadmap.edges[nearest.place.edge]);
      nearest.place.at = curve.nearest_place(point);
      const Vec2 apart = curve.point_at(nearest.place.at) - point;
      queue.push({dot(apart, apart), nearest.place, true});
      continue;
    }
    const Vec2 reached = point_of(axis, nearest.place);
    if (!map.walls().segment_clear(point, reached)) continue;
    const double at_most = std::min(map.clearance_at(point), map.clearance_at(reached));
    const double clearance = map.walls().segment_clearance(point, reached, at_most);
    if (clearance < radius - touching) continue;
    Entry entry{nearest.place, {point}, glm::length(reached - point), clearance};
    append_point(reached, entry.points);
    return entry;
  }
  auto entry = climb(map, point);
  if (entry && entry->clearance < radius - touching) entry.reset();
  return entry;
}

/// Search over the nodes of the roadmap from one place to another.
class RoadSearch {
 public:
  RoadSearch(const MedialAxisMap& axis, const RoadPlace& from, const RoadPlace& to)
      : axis_(axis), roadmap_(axis.roadmap()), from_(from), to_(to) {}

  /// The largest clearance that some way keeps; negative where there is none.
  double widest() {
    reset(-1);
    if (same_edge()) reach_goal(curve_of(from_.edge).clearance_between(from_.at, to_.at), none);
    start([&](std::uint32_t node, double, double clearance) { widen(node, clearance, none); });
    while (!queue_.empty()) {
      const auto [width, node] = pop();
      if (width != value_[node]) continue;
      if (width <= goal_value_) break;
      finish(node, [&](double, double clearance) { reach_goal(std::min(width, clearance), node); });
      for (const std::uint32_t e : axis_.edges_at(node))
        widen(other_end(e, node), std::min(width, roadmap_.edges[e].clearance), e);
    }
    return goal_value_;
  }

  /// The shortest way that keeps `clearance`. False where there is none.
  bool shortest(double clearance) {
    least_ = clearance - touching;
    reset(infinity);
    if (same_edge() && curve_of(from_.edge).clearance_between(from_.at, to_.at) >= least_)
      reach_goal_by(curve_of(from_.edge).length_between(from_.at, to_.at), none);
    const Vec2 goal = point_of(axis_, to_);
    const auto shorten = [&](std::uint32_t node, double length, std::uint32_t by) {
      if (length >= value_[node]) return;
      value_[node] = length;
      by_[node] = by;
      push(-(length + glm::length(goal - roadmap_.position[node])), node);
    };
    start([&](std::uint32_t node, double length, double width) {
      if (width >= least_) shorten(node, length, none);
    });
    std::vector<bool> done(value_.size(), false);
    while (!queue_.empty()) {
      const auto [bound, node] = pop();
      if (-bound >= goal_value_) break;
      if (done[node]) continue;
      done[node] = true;
      const double length = value_[node];
      finish(node, [&](double rest, double width) {
        if (width >= least_) reach_goal_by(length + rest, node);
      });
      for (const std::uint32_t e : axis_.edges_at(node))
        if (roadmap_.edges[e].clearance >= least_)
          shorten(other_end(e, node), length + roadmap_.edges[e].length, e);
    }
    return goal_value_ < infinity;
  }

  /// Appends the way that `shortest` found.
  void append_way(Way& way) const {
    way.length += goal_value_;
    if (goal_by_ == none) return append_piece(from_.edge, from_.at, to_.at, way);
    std::vector<std::uint32_t> edges;
    std::uint32_t node = goal_by_;
    for (; by_[node] != none; node = other_end(by_[node], node)) edges.push_back(by_[node]);
    if (from_.edge != none) append_piece(from_.edge, from_.at, place_of(from_.edge, node), way);
    for (const std::uint32_t e : std::views::reverse(edges)) {
      const std::uint32_t next = other_end(e, node);
      append_piece(e, place_of(e, node), place_of(e, next), way);
      node = next;
    }
    if (to_.edge != none) append_piece(to_.edge, place_of(to_.edge, goal_by_), to_.at, way);
  }

 private:
  const EdgeCurve& curve_of(std::uint32_t e) const { return axis_.curve_of(roadmap_.edges[e]); }
  std::uint32_t other_end(std::uint32_t e, std::uint32_t node) const {
    return roadmap_.edges[e].from == node ? roadmap_.edges[e].to : roadmap_.edges[e].from;
  }
  double place_of(std::uint32_t e, std::uint32_t node) const {
    return roadmap_.edges[e].from == node ? curve_of(e).begin() : curve_of(e).end();
  }
  bool same_edge() const { return from_.edge == to_.edge && from_.edge != none; }
  void reset(double unreached) {
    value_.assign(roadmap_.position.size(), unreached);
    by_.assign(roadmap_.position.size(), none);
    goal_value_ = unreached;
    goal_by_ = none;
    queue_.clear();
  }
  /// Calls visit(node, length, clearance) for the nodes beside the start.
  template <class Visit>
  void start(Visit visit) {
    if (from_.edge == none) return visit(from_.node, 0.0, infinity);
    const EdgeCurve& curve = curve_of(from_.edge);
    visit(roadmap_.edges[from_.edge].from, curve.length_between(from_.at, curve.begin()),
          curve.clearance_between(from_.at, curve.begin()));
    visit(roadmap_.edges[from_.edge].to, curve.length_between(from_.at, curve.end()),
          curve.clearance_between(from_.at, curve.end()));
  }
  /// Calls visit(length, clearance) for the ways from a node straight to the goal's place.
  template <class Visit>
  void finish(std::uint32_t node, Visit visit) {
    if (to_.edge == none) {
      if (node == to_.node) visit(0.0, infinity);
      return;
    }
    const EdgeCurve& curve = curve_of(to_.edge);
    const RoadmapEdge& edge = roadmap_.edges[to_.edge];
    if (node == edge.from)
      visit(curve.length_between(curve.begin(), to_.at),
            curve.clearance_between(curve.begin(), to_.at));
    if (node == edge.to)
      visit(curve.length_between(curve.end(), to_.at),
            curve.clearance_between(curve.end(), to_.at));
  }
  void widen(std::uint32_t node, double width, std::uint32_t by) {
    if (width <= value_[node]) return;
    value_[node] = width;
    by_[node] = by;
    push(width, node);
  }
  void reach_goal(double width, std::uint32_t node) {
    if (width <= goal_value_) return;
    goal_value_ = width;
    goal_by_ = node;
  }
  void reach_goal_by(double length, std::uint32_t node) {
    if (length >= goal_value_) return;
    goal_value_ = length;
    goal_by_ = node;
  }
  void append_piece(std::uint32_t e, double a, double b, Way& way) const {
    curve_of(e).append_points(a, b, way.points);
    way.clearance_min = std::min(way.clearance_min, curve_of(e).clearance_between(a, b));
  }
  void push(double priority, std::uint32_t node) {
    queue_.emplace_back(priority, node);
    std::push_heap(queue_.begin(), queue_.end());
  }
  std::pair<double, std::uint32_t> pop() {
    std::pop_heap(queue_.begin(), queue_.end());
    const auto top = queue_.back();
    queue_.pop_back();
    return top;
  }

  const MedialAxisMap& axis_;
  const Roadmap& roadmap_;
  RoadPlace from_, to_;
  double least_ = 0;
  std::vector<double> value_;      ///< Per node: its width, or the length of the way to it.
  std::vector<std::uint32_t> by_;  ///< Per node: the edge that the way came by.
  double goal_value_ = 0;
  std::uint32_t goal_by_ = none;  ///< The last node before the goal's place.
  std::vector<std::pair<double, std::uint32_t>> queue_;
};

Way way_between(const FloorMap& map, const RouteQuery& query, double clearance) {
  const auto from = nearest_entry(map, query.from, clearance);
  const auto to = nearest_entry(map, query.to, clearance);
  if (!from || !to) return {};
  RoadSearch search(map.medial_axis(), from->place, to->place);
  if (!search.shortest(clearance)) return {};
  Way way{RouteStatus::Ok, from->length, std::min(from->clearance, to->clearance), from->points};
  search.append_way(way);
  for (const Vec2 point : std::views::reverse(to->points)) append_point(point, way.points);
  way.length += to->length;
  if (way.points.size() == 1) way.points.push_back(query.to);
  return way;
}

}  // namespace

Way medial_axis_way(const FloorMap& map, const RouteQuery& query) {
  if (!query.widest) return way_between(map, query, query.radius);
  const auto from = climb(map, query.from), to = climb(map, query.to);
  if (!from || !to) return {};
  const double width = std::min({from->clearance, to->clearance,
                                 RoadSearch(map.medial_axis(), from->place, to->place).widest()});
  if (width < query.radius - touching || width < 0) return {};
  return way_between(map, query, width);
}

}  // namespace docent
