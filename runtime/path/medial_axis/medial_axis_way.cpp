#include "runtime/path/medial_axis/medial_axis_way.h"

#include <algorithm>
#include <array>
#include <functional>
#include <ranges>
#include <span>
#include <utility>

#include "runtime/model/none.h"
#include "runtime/path/closure/closed_doors.h"
#include "runtime/path/flatten.h"
#include "runtime/path/index/stamped_array.h"

namespace docent::path {
namespace {

using Place = RoadGraph::Place;

/// How a query's end point gets to the roadmap.
struct Entry {
  Place place;
  std::vector<Vec2> points;  ///< From the end point to the place, both included.
  double length = 0;
  double clearance = 0;
};

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
    entry.place = axis.roads().place_on(axis.roadmap_edge(edge), at);
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
      entry.place = axis.roads().place_at(axis.node_at(vertex));
      return entry;
    }
    edge = axis.edge_to_road(vertex);
    if (edge == none) return {};
    forward = voronoi.edge[edge].from == vertex;
    at = forward ? axis.curve(edge).begin() : axis.curve(edge).end();
  }
}

/// The nearest place of the roadmap that a straight line reaches which keeps the least clearance.
std::optional<Entry> nearest_entry(const FloorMap& map, Vec2 point, double least,
                                   const ClosedDoors* closed) {
  const double here = map.clearance_at(point);
  double clearance = 0;
  Vec2 reached;
  const auto place = map.medial_axis().nearest_road(point, [&](const Place&, Vec2 there) {
    if (!map.walls().segment_clear(point, there)) return false;
    const double to_leaf = closed != nullptr ? closed->distance(point, there) : infinity;
    if (to_leaf < least || to_leaf == 0) return false;
    reached = there;
    clearance =
        map.walls().segment_clearance(point, there, std::min(here, map.clearance_at(there)));
    return clearance >= least;
  });
  if (place) {
    Entry entry{*place, {point}, glm::length(reached - point), clearance};
    append_point(reached, entry.points);
    return entry;
  }
  auto entry = climb(map, point);
  if (entry && entry->clearance < least) entry.reset();
  if (entry && closed != nullptr && closed->crosses(entry->points)) entry.reset();
  return entry;
}

/// The largest clearance that some way on the roads keeps; negative where there is none.
double widest_clearance(const RoadGraph& roads, const Place& from, const Place& to) {
  double widest = -1;
  if (const auto direct = roads.between(from, to)) widest = direct->clearance;
  for (const auto& leave : roads.exits_of(from))
    for (const auto& arrive : roads.exits_of(to))
      if (leave.junction != none && arrive.junction != none)
        widest = std::max(widest, std::min({leave.clearance, arrive.clearance,
                                            roads.widest(leave.junction, arrive.junction)}));
  return widest;
}

/// What a search knows of a junction: the shortest way to it yet, and the road that it came by, as
/// `RoadGraph::roads_at` counts; none for those beside the start.
struct Visitor {
  double length = infinity;
  double least_rest = 0;  ///< No way on to the goal is shorter.
  std::uint32_t by = none;
  bool by_end = false;  ///< Beside the start: reached by the end of its road, not by the begin.
};

/// A* over the junctions, with the landmarks' bounds, along the roads that keep a clearance.
class RoadSearch {
 public:
  RoadSearch(const RoadGraph& roads, const Place& from, const Place& to, double least,
             const ClosedDoors* closed)
      : roads_(roads),
        closed_(closed),
        from_(from),
        to_(to),
        least_(least),
        to_goal_(roads.distances_of(to)),
        arrival_(roads.exits_of(to)),
        visit_(notes()) {
    visit_.forget(roads.junctions());
  }

  /// False where there is no way.
  bool find() {
    if (const auto direct = roads_.between(from_, to_);
        direct && direct->clearance >= least_ && is_open_between())
      length_ = direct->length;
    const auto departures = roads_.exits_of(from_);
    for (const auto& departure : departures)
      if (departure.junction != none && departure.clearance >= least_ &&
          is_open(from_, &departure == &departures[1]))
        shorten(departure.junction, departure.length, none, &departure == &departures[1]);
    while (!queue_.empty()) {
      std::ranges::pop_heap(queue_, std::greater{});
      const auto [bound, junction] = queue_.back();
      queue_.pop_back();
      if (bound >= length_) break;
      const Visitor& here = visit_[junction];
      if (bound > here.length + here.least_rest) continue;
      arrive(junction, here.length);
      leave(junction, here.length);
    }
    return length_ < infinity;
  }

  /// Appends the way that `find` found.
  void append_way(Way& way) const {
    way.length += length_;
    if (last_ == none) {
      way.clearance_min = std::min(way.clearance_min, roads_.between(from_, to_)->clearance);
      return roads_.append_between(from_, to_, way.points);
    }
    std::vector<std::uint32_t> back;  // The roads from the last junction to the first.
    std::uint32_t first = last_;
    while (visit_[first].by != none) {
      back.push_back(visit_[first].by);
      first = far_end(back.back() ^ 1U);
    }
    append_end_piece(from_, visit_[first].by_end, true, way);
    for (const std::uint32_t by : std::views::reverse(back)) {
      const Place begin = roads_.begin_of(by / 2), end = roads_.end_of(by / 2);
      by % 2 == 0 ? roads_.append_between(begin, end, way.points)
                  : roads_.append_between(end, begin, way.points);
      way.clearance_min = std::min(way.clearance_min, roads_.roads()[by / 2].clearance);
    }
    append_end_piece(to_, arrives_by_end_, false, way);
  }

 private:
  /// Kept per thread, so that no search has to make or clear them.
  static StampedArray<Visitor>& notes() {
    thread_local StampedArray<Visitor> kept;
    return kept;
  }
  std::span<const double> cuts_of(std::uint32_t road) const noexcept {
    if (closed_ == nullptr || road == none) return {};
    return closed_->cuts_of(road);
  }
  /// Is no closed door between a place and the end, or the begin, of its road?
  bool is_open(const Place& place, bool to_end) const {
    const double at = roads_.exits_of(place)[0].length;
    return std::ranges::none_of(cuts_of(roads_.road_of(place)),
                                [&](double cut) { return to_end ? cut >= at : cut <= at; });
  }
  /// And none between the two places of the query, along the road that both are on?
  bool is_open_between() const {
    const auto [first, last] =
        std::minmax({roads_.exits_of(from_)[0].length, roads_.exits_of(to_)[0].length});
    return std::ranges::none_of(cuts_of(roads_.road_of(from_)),
                                [&](double cut) { return first <= cut && cut <= last; });
  }
  /// The junction that a road, as `roads_at` counts, leads to.
  std::uint32_t far_end(std::uint32_t way) const {
    const RoadGraph::Road& road = roads_.roads()[way / 2];
    return way % 2 == 0 ? road.to : road.from;
  }
  void shorten(std::uint32_t junction, double length, std::uint32_t by, bool by_end = false) {
    const bool is_new = !visit_.has(junction);
    Visitor& visit = visit_[junction];
    if (length >= visit.length) return;
    const double rest = is_new ? roads_.least_distance(junction, to_goal_) : visit.least_rest;
    visit = {length, rest, by, by_end};
    if (length + rest >= length_) return;
    queue_.emplace_back(length + rest, junction);
    std::ranges::push_heap(queue_, std::greater{});
  }
  void arrive(std::uint32_t junction, double length) {
    for (const auto& arrival : arrival_) {
      if (arrival.junction != junction || arrival.clearance < least_ ||
          !is_open(to_, &arrival == &arrival_[1]))
        continue;
      if (length + arrival.length >= length_) continue;
      length_ = length + arrival.length;
      last_ = junction;
      arrives_by_end_ = &arrival == &arrival_[1];
    }
  }
  void leave(std::uint32_t junction, double length) {
    for (const std::uint32_t way : roads_.roads_at(junction)) {
      const RoadGraph::Road& road = roads_.roads()[way / 2];
      if (road.clearance >= least_ && cuts_of(way / 2).empty())
        shorten(far_end(way), length + road.length, way);
    }
  }
  /// The piece of road between the start or goal and the begin or the end of its road.
  void append_end_piece(const Place& place, bool by_end, bool leaving, Way& way) const {
    const std::uint32_t road = roads_.road_of(place);
    if (road == none) return append_point(roads_.point_at(place), way.points);
    const Place side = by_end ? roads_.end_of(road) : roads_.begin_of(road);
    leaving ? roads_.append_between(place, side, way.points)
            : roads_.append_between(side, place, way.points);
    way.clearance_min =
        std::min(way.clearance_min, roads_.exits_of(place)[by_end ? 1 : 0].clearance);
  }

  const RoadGraph& roads_;
  const ClosedDoors* closed_;
  Place from_, to_;
  double least_;
  RoadGraph::Distances to_goal_;
  std::array<RoadGraph::Exit, 2> arrival_;
  StampedArray<Visitor>& visit_;
  std::vector<std::pair<double, std::uint32_t>> queue_;
  double length_ = infinity;
  std::uint32_t last_ = none;  ///< The last junction; none on a way along one road.
  bool arrives_by_end_ = false;
};

Way way_between(const FloorMap& map, const RouteQuery& query, double least) {
  const auto from = nearest_entry(map, query.from, least, query.closed);
  const auto to = nearest_entry(map, query.to, least, query.closed);
  if (!from || !to) return {};
  const RoadGraph& roads = map.medial_axis().roads();
  if (widest_clearance(roads, from->place, to->place) < least) return {};
  RoadSearch search(roads, from->place, to->place, least, query.closed);
  if (!search.find()) return {};
  Way way{RouteStatus::Ok, from->length, std::min(from->clearance, to->clearance), from->points};
  search.append_way(way);
  for (const Vec2 point : std::views::reverse(to->points)) append_point(point, way.points);
  way.length += to->length;
  return way;
}

}  // namespace

Way medial_axis_way(const FloorMap& map, const RouteQuery& query) {
  const double least = least_clearance(query.radius);
  if (!query.widest) return way_between(map, query, least);
  const auto from = climb(map, query.from), to = climb(map, query.to);
  if (!from || !to) return {};
  const double width =
      std::min({from->clearance, to->clearance,
                widest_clearance(map.medial_axis().roads(), from->place, to->place)});
  if (width < least || width < -touching) return {};
  // Of ways that are equally wide but for `touching`, the shortest; but none that does not fit.
  return way_between(map, query, std::max(least_clearance(width), least));
}

}  // namespace docent::path
