#include "runtime/path/offset/offset_way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/model/none.h"
#include "runtime/path/closure/closed_doors.h"
#include "runtime/path/flatten.h"
#include "runtime/path/index/stamped_array.h"
#include "runtime/path/offset/offset_curve.h"

namespace docent::path {
namespace {

/// A directed piece of way between two nodes of the offset network.
struct OffsetLink {
  enum class Kind : std::uint8_t { Level, Chain, Axis, Road, Straight };
  Kind kind = Kind::Straight;
  bool crossing = false;  ///< Leaves the walls: along the axis of a wide place, or to it.
  std::uint32_t from = 0, to = 0;
  std::uint32_t along = 0;    ///< Level: the site. Axis: the Voronoi edge. Road: the road.
  double begin = 0, end = 0;  ///< Places on it. Road and chain: 0 its begin, 1 its end.
  double length = 0, clearance = 0;
  Vec2 reached{};  ///< The point of `to`.
};

void append_road(const RoadGraph& roads, const OffsetLink& link, std::vector<Vec2>& points) {
  const auto begin = roads.begin_of(link.along), end = roads.end_of(link.along);
  link.begin < link.end ? roads.append_between(begin, end, points)
                        : roads.append_between(end, begin, points);
}

void append_chain(const LevelCurve& curve, const OffsetLink& link, std::vector<Vec2>& points) {
  LevelCrossing at = link.from;
  do {
    const bool onwards = link.begin < link.end;
    const LevelPiece piece = onwards ? curve.piece_from(at) : curve.piece_to(at);
    onwards ? curve.append_points(piece.site, piece.begin, piece.end, points)
            : curve.append_points(piece.site, piece.end, piece.begin, points);
    at = onwards ? piece.to : piece.from;
  } while (at != link.to);
}

/// Appends the points of a link that begins where the points end.
void append_link(const MedialAxisMap& axis, const LevelCurve& curve, const OffsetLink& link,
                 std::vector<Vec2>& points) {
  switch (link.kind) {
    case OffsetLink::Kind::Level:
      return curve.append_points(link.along, link.begin, link.end, points);
    case OffsetLink::Kind::Axis:
      return axis.curve(link.along).append_points(link.begin, link.end, points);
    case OffsetLink::Kind::Chain:
      return append_chain(curve, link, points);
    case OffsetLink::Kind::Road:
      return append_road(axis.roads(), link, points);
    case OffsetLink::Kind::Straight:
      return append_point(link.reached, points);
  }
}

/// Where a query's end meets the walls' curve.
struct Attachment {
  std::uint32_t node = none;        ///< The place on the curve, or on the axis of a narrow place.
  std::optional<LevelPiece> piece;  ///< The piece of the curve that the node is on.
  double at = 0;                    ///< Where on it.
  std::optional<MedialAxisMap::Place> above;  ///< On the axis, straight away from the wall.
};

/// Everything that a way at one distance may use, worked out as the search comes to it. Nodes: the
/// curve's crossings, then the Voronoi vertices, then what the ends of the query add.
class Network {
 public:
  Network(const FloorMap& map, const LevelCurve& curve, double radius, const ClosedDoors* closed)
      : map_(map),
        closed_(closed),
        axis_(map.medial_axis()),
        curve_(curve),
        radius_(radius),
        first_vertex_(static_cast<std::uint32_t>(2 * axis_.diagram().edge.size())),
        first_own_(first_vertex_ + static_cast<std::uint32_t>(axis_.diagram().vertex.size())) {}

  /// Adds the ends of a query: nodes `start` and `goal`.
  void attach(Vec2 from, Vec2 to) {
    add_node(from);
    add_node(to);
    const Attachment first = attach_one(start()), last = attach_one(goal());
    if (first.piece && last.piece && first.piece->from == last.piece->from)
      add_level_between(first, last);
    if (first.above && last.above && first.above->voronoi_edge == last.above->voronoi_edge &&
        !first.piece && !last.piece)
      add_axis(first.above->voronoi_edge, first.node, first.above->at, last.node, last.above->at);
  }

  std::uint32_t start() const noexcept { return first_own_; }
  std::uint32_t goal() const noexcept { return first_own_ + 1; }
  std::size_t nodes() const noexcept { return first_own_ + own_.size(); }
  Vec2 position(std::uint32_t node) const noexcept {
    if (node < first_vertex_) return curve_.point_at(node);
    if (node < first_own_) return axis_.diagram().vertex[node - first_vertex_];
    return own_[node - first_own_];
  }

  /// Calls visit(link) for each link that leaves a node. Along the curve the wall is on the right:
  /// with the wall on the left it is walked backwards. Whoever wants the shorter hand may walk each
  /// wall either way.
  template <class Visitor>
  void visit_links(std::uint32_t node, Hand hand, Visitor visit) const {
    const auto visit_wide = [&](const OffsetLink& link) {
      if (link.clearance >= least_clearance(radius_) && link.to != node && is_open(link))
        visit(link);
    };
    if (node < first_vertex_) {
      if (hand != Hand::Left) visit_wide(chain_from(node));
      if (hand != Hand::Right) visit_wide(chain_to(node));
      if (axis_.diagram().edge[node / 2].on_medial_axis) visit_axis(node, node / 2, visit_wide);
    } else if (node < first_own_) {
      visit_roads(node, visit_wide);
    }
    for (const OffsetLink& link : link_) {
      if (link.from == node && (link.kind != OffsetLink::Kind::Level || hand != Hand::Left))
        visit_wide(link);
      if (link.to == node && (link.kind != OffsetLink::Kind::Level || hand != Hand::Right))
        visit_wide(turned_round(link));
    }
  }

 private:
  /// Is no closed door across a link?
  bool is_open(const OffsetLink& link) const {
    if (closed_ == nullptr) return true;
    thread_local std::vector<Vec2> points;  // kept, so that nobody has to make it
    points.assign(1, position(link.from));
    append_link(axis_, curve_, link, points);
    return !closed_->crosses(points);
  }
  std::uint32_t add_node(Vec2 point) {
    own_.push_back(point);
    return first_own_ + static_cast<std::uint32_t>(own_.size() - 1);
  }
  OffsetLink turned_round(OffsetLink link) const {
    std::swap(link.from, link.to);
    std::swap(link.begin, link.end);
    link.reached = position(link.to);
    return link;
  }
  /// A part of a piece of the curve.
  OffsetLink level_link(std::uint32_t site, std::uint32_t from, double begin, std::uint32_t to,
                        double end) const {
    return {OffsetLink::Kind::Level,
            false,
            from,
            to,
            site,
            begin,
            end,
            curve_.length_between(site, begin, end),
            curve_.distance(),
            position(to)};
  }
  /// The curve from a crossing to where one may next turn off: where it meets the axis, or to a
  /// piece with an end of the query.
  OffsetLink chain_from(LevelCrossing begin) const {
    OffsetLink link{OffsetLink::Kind::Chain, false, begin, begin, 0, 0, 1, 0, curve_.distance()};
    do {
      const LevelPiece piece = curve_.piece_from(link.to);
      link.length += curve_.length_between(piece.site, piece.begin, piece.end);
      link.to = piece.to;
      link.reached = piece.last;
      if (is_own_piece(piece.from) || is_own_piece(piece.to)) break;
    } while (link.to != begin && !is_on_axis(link.to));
    return link;
  }
  /// The same against its direction.
  OffsetLink chain_to(LevelCrossing end) const {
    OffsetLink link{OffsetLink::Kind::Chain, false, end, end, 0, 1, 0, 0, curve_.distance()};
    do {
      const LevelPiece piece = curve_.piece_to(link.to);
      link.length += curve_.length_between(piece.site, piece.begin, piece.end);
      link.to = piece.from;
      link.reached = piece.first;
      if (is_own_piece(piece.from) || ends_own_piece(piece.from)) break;
    } while (link.to != end && !is_on_axis(link.to));
    return link;
  }
  bool is_on_axis(LevelCrossing crossing) const {
    return axis_.diagram().edge[crossing / 2].on_medial_axis;
  }
  bool is_own_piece(LevelCrossing from) const {
    return from == own_piece_[0].first || from == own_piece_[1].first;
  }
  bool ends_own_piece(LevelCrossing to) const {
    return to == own_piece_[0].second || to == own_piece_[1].second;
  }
  OffsetLink axis_link(std::uint32_t e, std::uint32_t from, double begin, std::uint32_t to,
                       double end) const {
    const EdgeCurve& bisector = axis_.curve(e);
    const bool wide = curve_.passes(bisector.clearance_at((begin + end) / 2));
    return {OffsetLink::Kind::Axis,
            wide,
            from,
            to,
            e,
            begin,
            end,
            bisector.length_between(begin, end),
            bisector.clearance_between(begin, end),
            bisector.point_at(end)};
  }
  /// Is a road too narrow for the distance all along, and free of ends of the query? Then it is one
  /// link: no curve meets it, and what the roadmap leaves out beside it leads nowhere.
  bool is_narrow(std::uint32_t road) const {
    return !curve_.passes(axis_.roads().roads()[road].greatest_clearance) && road != own_road_[0] &&
           road != own_road_[1];
  }
  /// The road that a place of the axis is on, or that the twig with the place hangs on; none where
  /// that is a junction.
  std::uint32_t road_below(std::uint32_t e) const {
    for (;;) {
      if (axis_.roadmap_edge(e) != none) return axis_.roads().road_of_edge(axis_.roadmap_edge(e));
      // Of the two ends, the road lies beyond the one that does not lead back over this edge.
      const VoronoiEdge& edge = axis_.diagram().edge[e];
      const std::uint32_t vertex = axis_.edge_to_road(edge.to) != e ? edge.to : edge.from;
      if (axis_.node_at(vertex) != none)
        return axis_.roads().road_of(axis_.roads().place_at(axis_.node_at(vertex)));
      e = axis_.edge_to_road(vertex);
      if (e == none) return none;
    }
  }
  /// The links along the axis from a Voronoi vertex.
  template <class Visitor>
  void visit_roads(std::uint32_t node, Visitor visit) const {
    const RoadGraph& roads = axis_.roads();
    const std::uint32_t vertex = node - first_vertex_, at = axis_.node_at(vertex);
    const std::uint32_t junction = at == none ? none : roads.place_at(at).junction;
    for (const std::uint32_t e : axis_.axis_edges_at(vertex)) {
      const std::uint32_t edge = axis_.roadmap_edge(e);
      if (junction == none || edge == none || !is_narrow(roads.road_of_edge(edge)))
        visit_axis(node, e, visit);
    }
    if (junction == none) return;
    for (const std::uint32_t way : roads.roads_at(junction)) {
      if (!is_narrow(way / 2)) continue;
      const RoadGraph::Road& road = roads.roads()[way / 2];
      const double end = way % 2 == 0 ? 1 : 0;
      visit(OffsetLink{OffsetLink::Kind::Road, false, node,
                       node_of_junction(way % 2 == 0 ? road.to : road.from), way / 2, 1 - end, end,
                       road.length, road.clearance,
                       roads.position(way % 2 == 0 ? road.to : road.from)});
    }
  }
  std::uint32_t node_of_junction(std::uint32_t junction) const {
    const RoadGraph& roads = axis_.roads();
    return first_vertex_ + axis_.floor().roadmap.voronoi_vertex[roads.node_of(junction)];
  }
  void add_axis(std::uint32_t e, std::uint32_t from, double begin, std::uint32_t to, double end) {
    link_.push_back(axis_link(e, from, begin, to, end));
  }
  void add_straight(std::uint32_t from, std::uint32_t to, double clearance, bool crossing) {
    link_.push_back({OffsetLink::Kind::Straight, crossing, from, to, 0, 0, 0,
                     glm::length(position(to) - position(from)), clearance, position(to)});
  }

  /// The stops of an axis edge, in its direction: its ends and where the curve crosses it.
  struct Stop {
    std::uint32_t node;
    double at;
  };
  struct Stops {
    std::array<Stop, 4> stop;
    std::size_t count = 0;
  };
  Stops stops_of(std::uint32_t e) const {
    const VoronoiEdge& edge = axis_.diagram().edge[e];
    const LevelCurve::Crossings crossings = curve_.crossings_of(e);
    Stops stops;
    const auto add = [&](std::uint32_t node, double at) { stops.stop[stops.count++] = {node, at}; };
    add(first_vertex_ + edge.from, axis_.curve(e).begin());
    for (std::uint32_t i = 0; i < crossings.count; ++i) add(2 * e + i, crossings.at[i]);
    add(first_vertex_ + edge.to, axis_.curve(e).end());
    return stops;
  }
  /// The links along an axis edge from a stop of it to the ones beside it.
  template <class Visitor>
  void visit_axis(std::uint32_t node, std::uint32_t e, Visitor visit) const {
    const auto [stop, count] = stops_of(e);
    for (std::size_t i = 0; i < count; ++i) {
      if (stop[i].node != node) continue;
      if (i > 0) visit(axis_link(e, node, stop[i].at, stop[i - 1].node, stop[i - 1].at));
      if (i + 1 < count) visit(axis_link(e, node, stop[i].at, stop[i + 1].node, stop[i + 1].at));
    }
  }
  /// Joins a node at a place of an axis edge with the stops on both sides.
  void join_axis(std::uint32_t node, const MedialAxisMap::Place& place) {
    const auto [stop, count] = stops_of(place.voronoi_edge);
    const double sign = stop[count - 1].at >= stop[0].at ? 1 : -1;
    std::size_t after = 1;
    while (after + 1 < count && sign * stop[after].at < sign * place.at) ++after;
    add_axis(place.voronoi_edge, stop[after - 1].node, stop[after - 1].at, node, place.at);
    add_axis(place.voronoi_edge, node, place.at, stop[after].node, stop[after].at);
  }

  Attachment attach_one(std::uint32_t end) {
    const Vec2 point = position(end);
    const std::uint32_t site = map_.site_at(point);
    Attachment made;
    made.above = axis_.place_above(site, point);
    if (!made.above) return made;
    const double clearance = map_.clearance_at(point);
    const EdgeCurve& bisector = axis_.curve(made.above->voronoi_edge);
    const double height = bisector.clearance_at(made.above->at);
    own_road_[end - first_own_] = road_below(made.above->voronoi_edge);
    made.node = add_node(bisector.point_at(made.above->at));
    join_axis(made.node, *made.above);
    add_straight(end, made.node, std::min(clearance, height), curve_.passes(height));
    if (curve_.passes(height)) attach_to_curve(end, site, clearance, made);
    return made;
  }
  /// Goes straight to the nearest place of the curve about a site.
  void attach_to_curve(std::uint32_t end, std::uint32_t site, double clearance, Attachment& made) {
    const double at = curve_.place_of(site, position(end));
    double least = infinity;
    for (const LevelPiece& piece : curve_.pieces_in(site)) {
      const auto [low, high] = std::minmax(piece.begin, piece.end);
      const double inside = std::clamp(at, low, high);
      if (std::abs(inside - at) >= least) continue;
      least = std::abs(inside - at);
      made.piece = piece;
      made.at = inside;
    }
    if (!made.piece) return;
    own_piece_[end - first_own_] = {made.piece->from, made.piece->to};
    made.node = add_node(curve_.point_at(site, made.at));
    add_straight(end, made.node, std::min(clearance, curve_.distance()), false);
    link_.push_back(level_link(site, made.piece->from, made.piece->begin, made.node, made.at));
    link_.push_back(level_link(site, made.node, made.at, made.piece->to, made.piece->end));
  }
  /// Joins two places on one piece of the curve, in its direction; one place with itself in both.
  void add_level_between(const Attachment& first, const Attachment& last) {
    const LevelPiece& piece = *first.piece;
    const auto add = [&](const Attachment& from, const Attachment& to) {
      // A corner's places fall along the piece, a wall's grow.
      if ((to.at - from.at) * (piece.end - piece.begin) >= 0)
        link_.push_back(level_link(piece.site, from.node, from.at, to.node, to.at));
    };
    add(first, last);
    add(last, first);
  }

  const FloorMap& map_;
  const ClosedDoors* closed_;
  const MedialAxisMap& axis_;
  const LevelCurve& curve_;
  double radius_;
  std::uint32_t first_vertex_, first_own_;
  std::array<std::uint32_t, 2> own_road_{none, none};  ///< Above the query's ends.
  /// The crossings of the pieces below them.
  std::array<std::pair<LevelCrossing, LevelCrossing>, 2> own_piece_{std::pair{none, none},
                                                                    std::pair{none, none}};
  std::vector<Vec2> own_;  ///< Where the query's own nodes are.
  std::vector<OffsetLink>
      link_;  ///< Its own links; they can be walked both ways, but for the hand.
};

/// Are the ends of a query on walls, or in narrow places, between which one need not leave the
/// walls? Spreads from both ends in turn, so an island soon answers no. The hand does not matter:
/// the curve is closed.
bool keeps_to_walls(const Network& network) {
  thread_local StampedArray<std::uint8_t> seen;  // by which end; kept, so that nobody clears it
  seen.forget(network.nodes());
  std::array<std::vector<std::uint32_t>, 2> waiting{std::vector{network.start()},
                                                    std::vector{network.goal()}};
  seen[network.start()] = 0;
  seen[network.goal()] = 1;
  for (std::size_t turn = 0;; ++turn) {
    const auto end = static_cast<std::uint8_t>(turn % 2);
    if (waiting[end].size() == turn / 2) return false;
    const std::uint32_t node = waiting[end][turn / 2];
    bool met = false;
    network.visit_links(node, Hand::Shorter, [&](const OffsetLink& link) {
      if (link.crossing) return;
      if (seen.has(link.to)) {
        met = met || seen[link.to] != end;
        return;
      }
      seen[link.to] = end;
      waiting[end].push_back(link.to);
    });
    if (met) return true;
  }
}

/// A*, with the straight distance as what is left at least.
class NetworkSearch {
 public:
  NetworkSearch(const Network& network, Hand hand)
      : network_(network), hand_(hand), visit_(notes()) {}

  bool find(bool may_cross) {
    visit_.forget(network_.nodes());
    const Vec2 goal = network_.position(network_.goal());
    visit_[network_.start()].cost = 0;
    std::vector<std::pair<double, std::uint32_t>> queue{{0.0, network_.start()}};
    while (!queue.empty()) {
      std::ranges::pop_heap(queue, std::greater{});
      const auto [bound, node] = queue.back();
      queue.pop_back();
      if (node == network_.goal()) return true;
      const double cost = visit_[node].cost;
      if (bound > cost + visit_[node].least_rest) continue;
      network_.visit_links(node, hand_, [&](const OffsetLink& link) {
        if (link.crossing && !may_cross) return;
        const double next = cost + link.length * (link.crossing ? crossing_weight : 1);
        const bool is_new = !visit_.has(link.to);
        Visitor& there = visit_[link.to];
        if (next >= there.cost) return;
        if (is_new) there.least_rest = glm::length(goal - link.reached);
        there.cost = next;
        there.by = link;
        queue.emplace_back(next + there.least_rest, link.to);
        std::ranges::push_heap(queue, std::greater{});
      });
    }
    return false;
  }

  /// The links of the way found, in order.
  std::vector<OffsetLink> links() const {
    std::vector<OffsetLink> found;
    for (std::uint32_t node = network_.goal(); node != network_.start(); node = found.back().from)
      found.push_back(visit_[node].by);
    std::ranges::reverse(found);
    return found;
  }

 private:
  struct Visitor {
    double cost = infinity;
    double least_rest = 0;
    OffsetLink by;
  };
  /// Kept per thread, so that no search has to make or clear them.
  static StampedArray<Visitor>& notes() {
    thread_local StampedArray<Visitor> kept;
    return kept;
  }

  const Network& network_;
  Hand hand_;
  StampedArray<Visitor>& visit_;
};

Way way_along(const std::vector<OffsetLink>& links, const Network& network,
              const MedialAxisMap& axis, const LevelCurve& curve) {
  Way way{RouteStatus::Ok, 0, infinity, {network.position(network.start())}};
  for (const OffsetLink& link : links) {
    way.length += link.length;
    way.clearance_min = std::min(way.clearance_min, link.clearance);
    append_link(axis, curve, link, way.points);
  }
  return way;
}

}  // namespace

Way offset_way(const FloorMap& map, const RouteQuery& query) {
  constexpr double least_offset = 1e-3;  // metres: nearer than this it is the wall itself
  const double asked = std::isfinite(query.offset) ? query.offset : RouteQuery{}.offset;
  const MedialAxisMap& axis = map.medial_axis();
  const LevelCurve curve(axis, std::max({asked, query.radius, least_offset}));
  Network network(map, curve, query.radius, query.closed);
  network.attach(query.from, query.to);
  NetworkSearch search(network, query.hand);
  if (!search.find(!keeps_to_walls(network))) return {};
  return way_along(search.links(), network, axis, curve);
}

}  // namespace docent::path
