#include "runtime/path/offset_way.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>

#include "runtime/path/flatten.h"
#include "runtime/path/join_ways.h"
#include "runtime/path/offset_curve.h"

namespace docent {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t none = MedialAxisMap::none;

/// A directed piece of way between two nodes of the offset network.
struct Link {
  enum class Kind : std::uint8_t { Level, Axis, Straight };
  Kind kind = Kind::Straight;
  bool crossing = false;  ///< Leaves the walls: along the axis of a wide place, or to it.
  std::uint32_t from = 0, to = 0;
  std::uint32_t along = 0;  ///< Level: the site. Axis: the Voronoi edge.
  double begin = 0, end = 0;
  double length = 0, clearance = 0;
};

/// Everything that a way at one distance may use, for one hand. Nodes: the curve's crossings, then
/// the Voronoi vertices, then what ends of queries add.
class Network {
 public:
  Network(const FloorMap& map, const LevelCurve& curve, double radius, Hand hand)
      : map_(map), axis_(map.medial_axis()), curve_(curve), radius_(radius), hand_(hand) {
    for (const std::size_t nodes = curve.crossings().size() + axis_.diagram().vertex.size();
         position_.size() < nodes;)
      position_.push_back(position(static_cast<std::uint32_t>(position_.size())));
    for (const LevelPiece& piece : curve.pieces())
      add_level(piece.site, piece.from, piece.begin, piece.to, piece.end);
    for (std::uint32_t e = 0; e < axis_.diagram().edge.size(); ++e)
      if (axis_.diagram().edge[e].on_medial_axis) add_axis_edge(e);
  }

  Way way(Vec2 from, Vec2 to) {
    const std::uint32_t start = add_node(from), goal = add_node(to);
    attach(start, goal);
    list_links();
    for (const bool may_cross : {false, true})
      if (search(start, goal, may_cross)) return trace(start, goal);
    return {};
  }

 private:
  /// Where a query's end meets the network.
  struct Attachment {
    std::uint32_t node = none;   ///< The place on the curve, or on the axis of a narrow place.
    std::uint32_t piece = none;  ///< The piece of the curve that the node is on.
    double at = 0;               ///< Where on it.
    MedialAxisMap::Place above;  ///< The place on the axis, straight away from the wall.
  };

  Vec2 position(std::uint32_t node) const {
    const auto crossings = curve_.crossings();
    if (node < crossings.size())
      return axis_.curve(crossings[node].voronoi_edge).point_at(crossings[node].at);
    return axis_.diagram().vertex[node - crossings.size()];
  }
  std::uint32_t node_of_vertex(std::uint32_t vertex) const {
    return static_cast<std::uint32_t>(curve_.crossings().size()) + vertex;
  }
  std::uint32_t add_node(Vec2 point) {
    position_.push_back(point);
    return static_cast<std::uint32_t>(position_.size() - 1);
  }

  void add(Link link) {
    if (link.clearance >= radius_ - touching) link_.push_back(link);
  }
  static void turn_round(Link& link) {
    std::swap(link.from, link.to);
    std::swap(link.begin, link.end);
  }
  void add_both_ways(Link link) {
    add(link);
    turn_round(link);
    add(link);
  }
  /// Along the curve the wall is on the right: with the wall on the left it is walked backwards.
  /// Whoever wants the shorter hand may walk each wall either way.
  void add_level(std::uint32_t site, std::uint32_t from, double begin, std::uint32_t to,
                 double end) {
    Link link{Link::Kind::Level,
              false,
              from,
              to,
              site,
              begin,
              end,
              curve_.length_between(site, begin, end),
              curve_.distance()};
    if (hand_ == Hand::Shorter) return add_both_ways(link);
    if (hand_ == Hand::Left) turn_round(link);
    add(link);
  }
  void add_axis(std::uint32_t e, std::uint32_t from, double begin, std::uint32_t to, double end) {
    const EdgeCurve& bisector = axis_.curve(e);
    const bool wide = bisector.clearance_at((begin + end) / 2) > curve_.distance();
    add_both_ways({Link::Kind::Axis, wide, from, to, e, begin, end,
                   bisector.length_between(begin, end), bisector.clearance_between(begin, end)});
  }
  void add_straight(std::uint32_t from, std::uint32_t to, double clearance, bool crossing) {
    add_both_ways({Link::Kind::Straight, crossing, from, to, 0, 0, 0,
                   glm::length(position_[to] - position_[from]), clearance});
  }

  /// The stops of an axis edge, in its direction: its ends and where the curve crosses it.
  struct Stop {
    std::uint32_t node;
    double at;
  };
  std::vector<Stop> stops_of(std::uint32_t e) const {
    const VoronoiEdge& edge = axis_.diagram().edge[e];
    std::vector<Stop> stops{{node_of_vertex(edge.from), axis_.curve(e).begin()}};
    for (std::uint32_t c = curve_.first_crossing(e); c < curve_.end_crossing(e); ++c)
      stops.push_back({c, curve_.crossings()[c].at});
    stops.push_back({node_of_vertex(edge.to), axis_.curve(e).end()});
    return stops;
  }
  void add_axis_edge(std::uint32_t e) {
    const auto stops = stops_of(e);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i)
      add_axis(e, stops[i].node, stops[i].at, stops[i + 1].node, stops[i + 1].at);
  }
  /// Joins a node at a place of an axis edge with the stops on both sides.
  void join_axis(std::uint32_t node, const MedialAxisMap::Place& place) {
    const auto stops = stops_of(place.voronoi_edge);
    const double sign = stops.back().at >= stops.front().at ? 1 : -1;
    std::size_t after = 1;
    while (after + 1 < stops.size() && sign * stops[after].at < sign * place.at) ++after;
    add_axis(place.voronoi_edge, stops[after - 1].node, stops[after - 1].at, node, place.at);
    add_axis(place.voronoi_edge, node, place.at, stops[after].node, stops[after].at);
  }

  Attachment attach_one(std::uint32_t end) {
    const Vec2 point = position_[end];
    const std::uint32_t site = map_.site_at(point);
    const auto above = axis_.place_above(site, point);
    if (!above) return {};
    Attachment made{.above = *above};
    const double clearance = map_.clearance_at(point);
    const EdgeCurve& bisector = axis_.curve(above->voronoi_edge);
    const double height = bisector.clearance_at(above->at);
    const std::uint32_t top = add_node(bisector.point_at(above->at));
    join_axis(top, *above);
    add_straight(end, top, std::min(clearance, height), height > curve_.distance());
    made.node = top;
    if (height <= curve_.distance()) return made;

    const double at = curve_.place_of(site, point);
    double least = infinity;
    for (std::uint32_t p = 0; p < curve_.pieces().size(); ++p) {
      const LevelPiece& piece = curve_.pieces()[p];
      if (piece.site != site) continue;
      const auto [low, high] = std::minmax(piece.begin, piece.end);
      const double inside = std::clamp(at, low, high);
      if (std::abs(inside - at) >= least) continue;
      least = std::abs(inside - at);
      made.piece = p;
      made.at = inside;
    }
    if (made.piece == none) return made;
    const LevelPiece& piece = curve_.pieces()[made.piece];
    made.node = add_node(curve_.point_at(site, made.at));
    add_straight(end, made.node, std::min(clearance, curve_.distance()), false);
    add_level(site, piece.from, piece.begin, made.node, made.at);
    add_level(site, made.node, made.at, piece.to, piece.end);
    return made;
  }
  void attach(std::uint32_t start, std::uint32_t goal) {
    const Attachment from = attach_one(start), to = attach_one(goal);
    if (from.piece != none && from.piece == to.piece) {
      const std::uint32_t site = curve_.pieces()[from.piece].site;
      // A corner's places fall along the piece, a wall's grow.
      const bool in_order = (to.at - from.at) * (curve_.pieces()[from.piece].end -
                                                 curve_.pieces()[from.piece].begin) >=
                            0;
      if (in_order)
        add_level(site, from.node, from.at, to.node, to.at);
      else
        add_level(site, to.node, to.at, from.node, from.at);
    }
    if (from.node != none && to.node != none && from.above.voronoi_edge == to.above.voronoi_edge &&
        from.piece == none && to.piece == none)
      add_axis(from.above.voronoi_edge, from.node, from.above.at, to.node, to.above.at);
  }

  void list_links() {
    first_.assign(position_.size() + 1, 0);
    for (const Link& link : link_) ++first_[link.from + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    leaving_.resize(link_.size());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t l = 0; l < link_.size(); ++l) leaving_[fill[link_[l].from]++] = l;
  }

  bool search(std::uint32_t start, std::uint32_t goal, bool may_cross) {
    cost_.assign(position_.size(), infinity);
    by_.assign(position_.size(), none);
    std::vector<std::pair<double, std::uint32_t>> queue{{0.0, start}};
    cost_[start] = 0;
    while (!queue.empty()) {
      std::ranges::pop_heap(queue, std::greater{});
      const auto [cost, node] = queue.back();
      queue.pop_back();
      if (node == goal) return true;
      if (cost > cost_[node]) continue;
      for (std::uint32_t i = first_[node]; i < first_[node + 1]; ++i) {
        const Link& link = link_[leaving_[i]];
        if (link.crossing && !may_cross) continue;
        const double next = cost + link.length * (link.crossing ? crossing_weight : 1);
        if (next >= cost_[link.to]) continue;
        cost_[link.to] = next;
        by_[link.to] = leaving_[i];
        queue.emplace_back(next, link.to);
        std::ranges::push_heap(queue, std::greater{});
      }
    }
    return false;
  }

  Way trace(std::uint32_t start, std::uint32_t goal) const {
    std::vector<std::uint32_t> links;
    for (std::uint32_t node = goal; node != start; node = link_[by_[node]].from)
      links.push_back(by_[node]);
    Way way{RouteStatus::Ok, 0, infinity, {position_[start]}};
    for (const std::uint32_t l : std::views::reverse(links)) {
      const Link& link = link_[l];
      way.length += link.length;
      way.clearance_min = std::min(way.clearance_min, link.clearance);
      switch (link.kind) {
        case Link::Kind::Level:
          curve_.append_points(link.along, link.begin, link.end, way.points);
          break;
        case Link::Kind::Axis:
          axis_.curve(link.along).append_points(link.begin, link.end, way.points);
          break;
        case Link::Kind::Straight:
          append_point(position_[link.to], way.points);
          break;
      }
    }
    return way;
  }

  const FloorMap& map_;
  const MedialAxisMap& axis_;
  const LevelCurve& curve_;
  double radius_;
  Hand hand_;
  std::vector<Vec2> position_;  ///< Per node.
  std::vector<Link> link_;
  std::vector<std::uint32_t> first_, leaving_;  ///< The links that leave each node.
  std::vector<double> cost_;
  std::vector<std::uint32_t> by_;
};

}  // namespace

Way offset_tour(const FloorMap& map, const RouteQuery& query, std::span<const Vec2> stops) {
  constexpr double least_offset = 1e-3;  // metres: nearer than this it is the wall itself
  const double asked = std::isfinite(query.offset) ? query.offset : RouteQuery{}.offset;
  const LevelCurve curve(map.medial_axis(), std::max({asked, query.radius, least_offset}));
  const Network network(map, curve, query.radius, query.hand);
  Way whole;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const Way leg = Network(network).way(stops[i], stops[i + 1]);
    if (leg.status != RouteStatus::Ok) return leg;
    if (i == 0)
      whole = leg;
    else
      join(whole, leg);
  }
  return whole;
}

Way offset_way(const FloorMap& map, const RouteQuery& query) {
  return offset_tour(map, query, std::array{query.from, query.to});
}

}  // namespace docent
