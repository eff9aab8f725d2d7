#include "content/floor/voronoi.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>
#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "content/content_error.h"
#include "content/floor/tritangent.h"

namespace docent {
namespace {

using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
using Doubles = CGAL::Simple_cartesian<double>;
// Mended walls meet at their ends only, so the variant without intersections is complete. Where the
// filter fails (walls of a regular plan are often equally far), numbers without division are three
// times as fast as CGAL's default, rationals.
using Exact = CGAL::Simple_cartesian<CGAL::internal::Exact_ring_selector<double>::Type>;
using Traits = CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<
    Doubles, CGAL::Field_with_sqrt_tag, Exact, CGAL::Integral_domain_without_division_tag>;
using Graph = CGAL::Segment_Delaunay_graph_2<Traits>;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
/// Voronoi vertices closer than this are one vertex at which more than three sites meet.
constexpr double same_vertex = 1e-10;

using Coordinates = std::pair<double, double>;

Coordinates coordinates_of(Vec2 p) {
  return {p.x, p.y};
}
Coordinates coordinates_of(const Graph::Point_2& p) {
  return {p.x(), p.y()};
}

std::vector<std::uint32_t> previous_vertices(const FloorPlan& plan) {
  std::vector<std::uint32_t> previous(plan.vertex.size(), none);
  for (std::uint32_t i = 0; i < plan.next.size(); ++i) previous[plan.next[i]] = i;
  return previous;
}

/// Corners that do not turn left, so that the floor goes round them. A corner that is straight on
/// (another wall's corner touches there) has a region, too: a line.
std::vector<std::uint32_t> reflex_corners(const FloorPlan& plan) {
  const std::vector<std::uint32_t> previous = previous_vertices(plan);
  const auto point = [&](std::uint32_t i) {
    return Predicates::Point_2(plan.vertex[i].x, plan.vertex[i].y);
  };
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i)
    if (CGAL::orientation(point(previous[i]), point(i), point(plan.next[i])) != CGAL::LEFT_TURN)
      corners.push_back(i);
  return corners;
}

std::vector<Site> make_sites(const FloorPlan& plan) {
  std::vector<Site> sites;
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) sites.push_back({Site::Kind::Wall, i});
  for (const std::uint32_t corner : reflex_corners(plan))
    sites.push_back({Site::Kind::Corner, corner});
  return sites;
}

[[noreturn]] void refuse(const FloorPlan& plan) {
  throw ContentError(plan.name, 0, 0, "crossing-walls", "the walls of a floor cross or overlap");
}

Graph make_graph(const FloorPlan& plan) {
  std::vector<Graph::Point_2> points;
  std::vector<std::pair<std::size_t, std::size_t>> walls;
  for (const Vec2 vertex : plan.vertex) points.emplace_back(vertex.x, vertex.y);
  for (std::uint32_t i = 0; i < plan.next.size(); ++i) walls.emplace_back(i, plan.next[i]);
  Graph graph;
  graph.insert_segments(points, walls.begin(), walls.end());
  // A wall that crosses another is left out with no more than a word on standard error.
  std::size_t inserted = 0;
  for (auto v = graph.finite_vertices_begin(); v != graph.finite_vertices_end(); ++v)
    inserted += v->is_segment() ? 1 : 0;
  if (inserted != walls.size()) refuse(plan);
  return graph;
}

/// A site of the graph in terms of the plan. Corners around which no floor lies have no site.
struct GraphSite {
  bool is_wall = false;
  std::uint32_t wall = none;  ///< Of a wall.
  std::uint32_t site = none;  ///< Index into VoronoiDiagram::site.
  Vec2 a{}, b{};
};

/// Knows the graph's vertices by their coordinates.
class SiteIndex {
 public:
  SiteIndex(const FloorPlan& plan, const std::vector<Site>& sites) : plan_(plan) {
    for (std::uint32_t i = 0; i < plan.next.size(); ++i)
      walls_[{coordinates_of(plan.vertex[i]), coordinates_of(plan.vertex[plan.next[i]])}] = i;
    for (std::uint32_t s = 0; s < sites.size(); ++s)
      if (sites[s].kind == Site::Kind::Corner)
        corners_[coordinates_of(plan.vertex[sites[s].index])] = s;
  }

  [[nodiscard]] GraphSite find(const Graph::Vertex_handle& vertex) const {
    const Graph::Site_2 site = vertex->site();
    if (site.is_point()) {
      const auto [x, y] = coordinates_of(site.point());
      const auto found = corners_.find({x, y});
      return {.site = found == corners_.end() ? none : found->second, .a = {x, y}};
    }
    const Coordinates a = coordinates_of(site.source()), b = coordinates_of(site.target());
    auto found = walls_.find({a, b});
    if (found == walls_.end()) found = walls_.find({b, a});
    if (found == walls_.end()) return {.is_wall = true};
    const std::uint32_t wall = found->second;
    return {.is_wall = true,
            .wall = wall,
            .site = wall,
            .a = wall_start(plan_, wall),
            .b = wall_end(plan_, wall)};
  }

 private:
  const FloorPlan& plan_;
  std::map<std::pair<Coordinates, Coordinates>, std::uint32_t> walls_;
  std::map<Coordinates, std::uint32_t> corners_;
};

/// A Voronoi vertex before it has a number.
struct Meeting {
  std::array<std::uint32_t, 3> sites{};  ///< Counter-clockwise, the smallest first.
  bool at_corner = false;                ///< Its sites meet in one corner of the plan.
  TritangentDisc disc;
};

bool touches(const GraphSite& site, Vec2 point) {
  return site.a == point || (site.is_wall && site.b == point);
}

bool meet_in_a_corner(const std::array<GraphSite, 3>& sites) {
  const auto all_touch = [&](Vec2 p) {
    return std::ranges::all_of(sites, [p](const GraphSite& site) { return touches(site, p); });
  };
  return all_touch(sites[0].a) || (sites[0].is_wall && all_touch(sites[0].b));
}

Meeting make_meeting(const std::array<GraphSite, 3>& sites) {
  Meeting meeting;
  for (std::size_t i = 0; i < 3; ++i) meeting.sites[i] = sites[i].site;
  std::ranges::rotate(meeting.sites, std::ranges::min_element(meeting.sites));
  meeting.at_corner = meet_in_a_corner(sites);
  if (meeting.at_corner) return meeting;
  const bool on_floor =
      std::ranges::none_of(sites, [](const GraphSite& s) { return s.site == none; });
  const auto tangent_site = [](const GraphSite& s) { return TangentSite{s.is_wall, s.a, s.b}; };
  if (on_floor)
    meeting.disc =
        tritangent_disc({tangent_site(sites[0]), tangent_site(sites[1]), tangent_site(sites[2])});
  return meeting;
}

/// One end of an edge: a corner of the plan, or where three sites meet.
struct EdgeEnd {
  std::uint32_t corner = none;
  std::array<std::uint32_t, 3> meeting{};
  auto operator<=>(const EdgeEnd&) const = default;
};

/// An edge before its ends have numbers; left < right.
struct RawEdge {
  std::uint32_t left = 0, right = 0;
  EdgeEnd from, to;
  auto operator<=>(const RawEdge&) const = default;
};

/// The corner of the plan at which two sites of one wedge of floor meet.
std::uint32_t shared_corner(const FloorPlan& plan, Site a, Site b) {
  const bool a_wall = a.kind == Site::Kind::Wall, b_wall = b.kind == Site::Kind::Wall;
  if (a_wall && b_wall) {
    if (plan.next[a.index] == b.index) return b.index;
    return plan.next[b.index] == a.index ? a.index : none;
  }
  if (a_wall == b_wall) return none;
  const auto [wall, corner] = a_wall ? std::pair(a.index, b.index) : std::pair(b.index, a.index);
  return wall == corner || plan.next[wall] == corner ? corner : none;
}

/// Picks the edges of the graph's dual that lie on the floor.
class EdgeCollector {
 public:
  EdgeCollector(const FloorPlan& plan, const std::vector<Site>& sites, const Graph& graph)
      : plan_(plan), sites_(sites), graph_(graph), index_(plan, sites) {}

  std::vector<RawEdge> collect() {
    std::vector<RawEdge> edges;
    for (auto edge = graph_.finite_edges_begin(); edge != graph_.finite_edges_end(); ++edge)
      add(edge->first, edge->second, edges);
    std::ranges::sort(edges);
    return edges;
  }

  [[nodiscard]] const TritangentDisc& disc_at(const EdgeEnd& end) const {
    return discs_.at(end.meeting);
  }

 private:
  void add(const Graph::Face_handle& face, int i, std::vector<RawEdge>& edges) {
    const Graph::Face_handle across = face->neighbor(i);
    if (graph_.is_infinite(face) || graph_.is_infinite(across)) return;
    // Seen from this face, whose vertex i is behind us, the counter-clockwise next is on the right.
    const GraphSite left = index_.find(face->vertex(Graph::cw(i)));
    const GraphSite right = index_.find(face->vertex(Graph::ccw(i)));
    if (left.site == none || right.site == none) return;
    const Meeting from = meeting_at(face), to = meeting_at(across);
    const auto is_on_floor = [](const Meeting& m) { return !m.at_corner && m.disc.radius > 0; };
    if (!is_on_floor(from) && !is_on_floor(to)) return;

    RawEdge edge{left.site, right.site, end_at(from, left, right), end_at(to, left, right)};
    if (edge.left > edge.right) {
      std::swap(edge.left, edge.right);
      std::swap(edge.from, edge.to);
    }
    edges.push_back(edge);
  }

  EdgeEnd end_at(const Meeting& meeting, const GraphSite& left, const GraphSite& right) {
    if (meeting.at_corner) {
      const std::uint32_t corner = shared_corner(plan_, sites_[left.site], sites_[right.site]);
      if (corner != none) return {.corner = corner};
    }
    if (meeting.at_corner || !(meeting.disc.radius > 0)) refuse(plan_);
    discs_[meeting.sites] = meeting.disc;
    return {.meeting = meeting.sites};
  }

  [[nodiscard]] Meeting meeting_at(const Graph::Face_handle& face) const {
    return make_meeting(
        {index_.find(face->vertex(0)), index_.find(face->vertex(1)), index_.find(face->vertex(2))});
  }

  const FloorPlan& plan_;
  const std::vector<Site>& sites_;
  const Graph& graph_;
  SiteIndex index_;
  std::map<std::array<std::uint32_t, 3>, TritangentDisc> discs_;
};

/// Groups of numbers that are the same, each named by its smallest member.
class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t name_of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = name_of(a), b = name_of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Numbers the ends of all edges: corners first, so that a group with a corner is named by it.
std::map<EdgeEnd, std::uint32_t> number_ends(const std::vector<RawEdge>& edges) {
  std::map<EdgeEnd, std::uint32_t> number;
  for (const RawEdge& edge : edges) number[edge.from] = number[edge.to] = 0;
  std::uint32_t count = 0;
  for (auto& [end, n] : number)
    if (end.corner != none) n = count++;
  for (auto& [end, n] : number)
    if (end.corner == none) n = count++;
  return number;
}

bool separates_wall_from_own_corner(const FloorPlan& plan, Site a, Site b) {
  return a.kind != b.kind && shared_corner(plan, a, b) != none;
}

/// Fills in vertices, clearance and edges. Vertices that coincide become one, and the edges
/// between them, at which only more than three sites meet, vanish.
void add_vertices_and_edges(const FloorPlan& plan, const std::vector<RawEdge>& raw,
                            const EdgeCollector& collector, VoronoiDiagram& diagram) {
  const std::map<EdgeEnd, std::uint32_t> number = number_ends(raw);
  std::vector<Vec2> position(number.size());
  std::vector<double> clearance(number.size(), 0.0);
  for (const auto& [end, n] : number) {
    position[n] = end.corner != none ? plan.vertex[end.corner] : collector.disc_at(end).centre;
    if (end.corner == none) clearance[n] = collector.disc_at(end).radius;
  }

  Groups groups(number.size());
  for (const RawEdge& edge : raw) {
    const std::uint32_t from = number.at(edge.from), to = number.at(edge.to);
    if (glm::distance(position[from], position[to]) < same_vertex) groups.join(from, to);
  }
  std::vector<std::uint32_t> index(number.size(), none);
  for (std::uint32_t n = 0; n < index.size(); ++n) {
    if (groups.name_of(n) != n) continue;
    index[n] = static_cast<std::uint32_t>(diagram.vertex.size());
    diagram.vertex.push_back(position[n]);
    diagram.clearance.push_back(clearance[n]);
  }
  for (const RawEdge& edge : raw) {
    const std::uint32_t from = groups.name_of(number.at(edge.from));
    const std::uint32_t to = groups.name_of(number.at(edge.to));
    if (from == to) continue;
    const Site left = diagram.site[edge.left], right = diagram.site[edge.right];
    const bool on_medial_axis = !separates_wall_from_own_corner(plan, left, right);
    diagram.edge.push_back({.from = index[from],
                            .to = index[to],
                            .left = edge.left,
                            .right = edge.right,
                            .on_medial_axis = on_medial_axis,
                            .parabola = on_medial_axis && left.kind != right.kind});
  }
}

/// An edge as its region's boundary runs along it.
struct Side {
  std::uint32_t region = 0;
  std::uint32_t start = 0, end = 0;  ///< Voronoi vertices.
  std::uint32_t edge = 0;
};

/// Puts the sides of one region in a row, each beginning where the one before ends, from `start`.
/// The row of a wall's region is open; the wall itself closes it.
void link(const FloorPlan& plan, std::span<Side> sides, std::uint32_t start) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::span<Side> rest = sides.subspan(i);
    const auto next = std::ranges::find(rest, start, &Side::start);
    if (next == rest.end()) refuse(plan);
    std::iter_swap(rest.begin(), next);
    start = sides[i].end;
  }
}

std::uint32_t find_vertex_at(const VoronoiDiagram& diagram, std::span<const Side> sides,
                             Vec2 corner) {
  for (const Side& side : sides)
    if (diagram.vertex[side.start] == corner) return side.start;
  return none;
}

void add_regions(const FloorPlan& plan, VoronoiDiagram& diagram) {
  std::vector<Side> sides;
  for (std::uint32_t e = 0; e < diagram.edge.size(); ++e) {
    const VoronoiEdge& edge = diagram.edge[e];
    sides.push_back({edge.left, edge.from, edge.to, e});
    sides.push_back({edge.right, edge.to, edge.from, e});
  }
  std::ranges::stable_sort(sides, {}, &Side::region);
  std::size_t first = 0;
  for (std::uint32_t region = 0; region < diagram.site.size(); ++region) {
    std::size_t end = first;
    while (end < sides.size() && sides[end].region == region) ++end;
    const std::span<Side> own = std::span(sides).subspan(first, end - first);
    const auto [kind, index] = diagram.site[region];
    const std::uint32_t corner = kind == Site::Kind::Wall ? plan.next[index] : index;
    link(plan, own, find_vertex_at(diagram, own, plan.vertex[corner]));
    diagram.region_first.push_back(static_cast<std::uint32_t>(first));
    first = end;
  }
  diagram.region_first.push_back(static_cast<std::uint32_t>(sides.size()));
  for (const Side& side : sides) diagram.region_edge.push_back(side.edge);
}

}  // namespace

VoronoiDiagram voronoi_diagram(const FloorPlan& plan) {
  VoronoiDiagram diagram;
  diagram.site = make_sites(plan);
  const Graph graph = make_graph(plan);
  EdgeCollector collector(plan, diagram.site, graph);
  const std::vector<RawEdge> edges = collector.collect();
  add_vertices_and_edges(plan, edges, collector, diagram);
  add_regions(plan, diagram);
  return diagram;
}

}  // namespace docent
