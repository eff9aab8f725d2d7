#include "content/floor/voronoi.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "content/content_error.h"
#include "content/floor/site_graph.h"
#include "content/floor/tritangent.h"
#include "runtime/model/none.h"

namespace docent::floor {
namespace {

/// Voronoi vertices closer than this are one vertex at which more than three sites meet.
constexpr double same_vertex = 1e-10;
/// Metres. A disc that misses one of its sites by more than this touches none of them from the
/// floor: its sites are walls on one line, and what was computed is noise.
constexpr double farthest_miss = 1e-6;

[[noreturn]] void refuse(const FloorPlan& plan) {
  throw content::ContentError(plan.name, 0, 0, "crossing-walls",
                              "the walls of a floor cross or overlap");
}

std::vector<Site> make_sites(const FloorPlan& plan, std::span<const std::uint32_t> reflex_corners) {
  std::vector<Site> sites;
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) sites.push_back({Site::Kind::Wall, i});
  for (const std::uint32_t corner : reflex_corners) sites.push_back({Site::Kind::Corner, corner});
  return sites;
}

/// A site of the graph in terms of the plan. Corners around which no floor lies have no site.
struct GraphSite {
  bool is_wall = false;
  std::uint32_t site = none;  ///< Index into VoronoiDiagram::site.
  Vec2 a{}, b{};
};

/// A triangle of the graph, or rather the disc that touches its sites.
struct Meeting {
  std::array<std::uint32_t, 3> sites{};  ///< Counter-clockwise, the smallest first.
  bool at_corner = false;                ///< Its sites meet in one corner of the plan.
  bool on_floor = false;                 ///< The disc is a Voronoi vertex of the floor.
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

bool misses(const TritangentDisc& disc, const GraphSite& site) {
  const Vec2 along = site.b - site.a;
  const double t = site.is_wall ? dot(disc.centre - site.a, along) / dot(along, along) : 0.0;
  const double distance = glm::distance(disc.centre, site.a + std::clamp(t, 0.0, 1.0) * along);
  return !(std::abs(distance - disc.radius) < farthest_miss);
}

Meeting make_meeting(const std::array<GraphSite, 3>& sites) {
  Meeting meeting;
  for (std::size_t i = 0; i < 3; ++i) meeting.sites[i] = sites[i].site;
  std::ranges::rotate(meeting.sites, std::ranges::min_element(meeting.sites));
  meeting.at_corner = meet_in_a_corner(sites);
  const bool all_face_floor =
      std::ranges::none_of(sites, [](const GraphSite& s) { return s.site == none; });
  if (meeting.at_corner || !all_face_floor) return meeting;
  const auto tangent_site = [](const GraphSite& s) { return TangentSite{s.is_wall, s.a, s.b}; };
  meeting.disc =
      tritangent_disc({tangent_site(sites[0]), tangent_site(sites[1]), tangent_site(sites[2])});
  meeting.on_floor = meeting.disc.radius > 0 &&
                     std::ranges::none_of(
                         sites, [&](const GraphSite& site) { return misses(meeting.disc, site); });
  return meeting;
}

/// An edge before its ends are Voronoi vertices; left < right. An end is a corner of the plan or,
/// counted on from the last of those, a triangle of the graph; in the end, its place in the order
/// of all ends.
struct RawEdge {
  std::uint32_t left = 0, right = 0;
  std::uint32_t from = 0, to = 0;
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
  EdgeCollector(const FloorPlan& plan, const std::vector<Site>& sites, const SiteGraph& graph)
      : plan_(plan), sites_(sites), corner_site_(plan.vertex.size(), none) {
    for (std::uint32_t s = 0; s < sites.size(); ++s)
      if (sites[s].kind == Site::Kind::Corner) corner_site_[sites[s].index] = s;
    meetings_.reserve(graph.triangle.size());
    for (const SiteTriangle& triangle : graph.triangle) {
      const auto& site = triangle.site;
      meetings_.push_back(make_meeting({find(site[0]), find(site[1]), find(site[2])}));
    }
    for (std::uint32_t t = 0; t < graph.triangle.size(); ++t)
      for (std::uint32_t side = 0; side < 3; ++side)
        if (const std::uint32_t across = graph.triangle[t].neighbour[side];
            across != none && t < across)
          add(graph.triangle[t], t, side);
    number_ends();
    std::ranges::sort(edges_);
  }

  /// In an order that depends on the plan alone.
  [[nodiscard]] const std::vector<RawEdge>& edges() const { return edges_; }
  /// How many ends they have: corners first, so that a group with a corner is named by it.
  [[nodiscard]] std::uint32_t count_ends() const {
    return static_cast<std::uint32_t>(ends_.size());
  }
  /// Where an end lies, with its distance from the walls.
  [[nodiscard]] TritangentDisc disc_at(std::uint32_t end) const {
    if (is_corner(ends_[end])) return {plan_.vertex[ends_[end]], 0};
    return meeting_at(ends_[end]).disc;
  }

 private:
  [[nodiscard]] std::uint32_t diagram_site(std::uint32_t number) const {
    if (number < plan_.next.size()) return number;
    return number == none ? none : corner_site_[number - plan_.next.size()];
  }
  [[nodiscard]] GraphSite find(std::uint32_t number) const {
    const std::uint32_t site = diagram_site(number);
    if (number == none) return {};
    if (number < plan_.next.size())
      return {true, site, wall_start(plan_, number), wall_end(plan_, number)};
    return {.site = site, .a = plan_.vertex[number - plan_.next.size()]};
  }
  [[nodiscard]] bool is_corner(std::uint32_t end) const { return end < plan_.vertex.size(); }
  [[nodiscard]] const Meeting& meeting_at(std::uint32_t end) const {
    return meetings_[end - plan_.vertex.size()];
  }

  void add(const SiteTriangle& triangle, std::uint32_t t, std::uint32_t side) {
    // Seen from this triangle, whose site `side` is behind us, the next but one is on the left.
    const std::uint32_t left = diagram_site(triangle.site[(side + 2) % 3]);
    const std::uint32_t right = diagram_site(triangle.site[(side + 1) % 3]);
    const std::uint32_t across = triangle.neighbour[side];
    if (left == none || right == none) return;
    if (!meetings_[t].on_floor && !meetings_[across].on_floor) return;
    RawEdge edge{left, right, end_at(t, left, right), end_at(across, left, right)};
    if (edge.left > edge.right) {
      std::swap(edge.left, edge.right);
      std::swap(edge.from, edge.to);
    }
    edges_.push_back(edge);
  }

  [[nodiscard]] std::uint32_t end_at(std::uint32_t triangle, std::uint32_t left,
                                     std::uint32_t right) const {
    if (meetings_[triangle].at_corner) {
      const std::uint32_t corner = shared_corner(plan_, sites_[left], sites_[right]);
      if (corner != none) return corner;
    }
    if (!meetings_[triangle].on_floor) refuse(plan_);
    return static_cast<std::uint32_t>(plan_.vertex.size()) + triangle;
  }

  void number_ends() {
    for (const RawEdge& edge : edges_) ends_.insert(ends_.end(), {edge.from, edge.to});
    std::ranges::sort(ends_);
    ends_.erase(std::ranges::unique(ends_).begin(), ends_.end());
    const auto first_triangle =
        std::ranges::partition_point(ends_, [this](std::uint32_t end) { return is_corner(end); });
    std::sort(first_triangle, ends_.end(), [this](std::uint32_t a, std::uint32_t b) {
      return meeting_at(a).sites < meeting_at(b).sites;
    });
    std::vector<std::uint32_t> number(plan_.vertex.size() + meetings_.size(), none);
    for (std::uint32_t n = 0; n < ends_.size(); ++n) number[ends_[n]] = n;
    for (RawEdge& edge : edges_) {
      edge.from = number[edge.from];
      edge.to = number[edge.to];
    }
  }

  const FloorPlan& plan_;
  const std::vector<Site>& sites_;
  std::vector<std::uint32_t> corner_site_;  ///< Per vertex of the plan.
  std::vector<Meeting> meetings_;           ///< Per triangle of the graph.
  std::vector<RawEdge> edges_;
  std::vector<std::uint32_t> ends_;  ///< By number.
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

bool separates_wall_from_own_corner(const FloorPlan& plan, Site a, Site b) {
  return a.kind != b.kind && shared_corner(plan, a, b) != none;
}

/// Fills in vertices, clearance and edges. Vertices that coincide become one, and the edges
/// between them, at which only more than three sites meet, vanish.
void add_vertices_and_edges(const FloorPlan& plan, const EdgeCollector& collector,
                            VoronoiDiagram& diagram) {
  std::vector<TritangentDisc> disc;
  for (std::uint32_t n = 0; n < collector.count_ends(); ++n) disc.push_back(collector.disc_at(n));

  Groups groups(disc.size());
  for (const RawEdge& edge : collector.edges())
    if (glm::distance(disc[edge.from].centre, disc[edge.to].centre) < same_vertex)
      groups.join(edge.from, edge.to);
  std::vector<std::uint32_t> index(disc.size(), none);
  for (std::uint32_t n = 0; n < index.size(); ++n) {
    if (groups.name_of(n) != n) continue;
    index[n] = static_cast<std::uint32_t>(diagram.vertex.size());
    diagram.vertex.push_back(disc[n].centre);
    diagram.clearance.push_back(disc[n].radius);
  }
  for (const RawEdge& edge : collector.edges()) {
    const std::uint32_t from = groups.name_of(edge.from), to = groups.name_of(edge.to);
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
struct EdgeSide {
  std::uint32_t region = 0;
  std::uint32_t start = 0, end = 0;  ///< Voronoi vertices.
  std::uint32_t edge = 0;
};

/// Puts the sides of one region, which are sorted by their starts, in a row, each beginning where
/// the one before ends, from `start`. The row of a wall's region is open; the wall itself closes
/// it.
void link(const FloorPlan& plan, std::span<EdgeSide> sides, std::uint32_t start) {
  std::vector<EdgeSide> row;
  row.reserve(sides.size());
  while (row.size() < sides.size()) {
    const auto next = std::ranges::lower_bound(sides, start, {}, &EdgeSide::start);
    if (next == sides.end() || next->start != start) refuse(plan);
    row.push_back(*next);
    start = next->end;
  }
  std::ranges::copy(row, sides.begin());
}

std::uint32_t find_vertex_at(const VoronoiDiagram& diagram, std::span<const EdgeSide> sides,
                             Vec2 corner) {
  for (const EdgeSide& side : sides)
    if (diagram.vertex[side.start] == corner) return side.start;
  return none;
}

void add_regions(const FloorPlan& plan, VoronoiDiagram& diagram) {
  std::vector<EdgeSide> sides;
  for (std::uint32_t e = 0; e < diagram.edge.size(); ++e) {
    const VoronoiEdge& edge = diagram.edge[e];
    sides.push_back({edge.left, edge.from, edge.to, e});
    sides.push_back({edge.right, edge.to, edge.from, e});
  }
  std::ranges::sort(sides, {}, [](const EdgeSide& side) {
    return std::tuple(side.region, side.start, side.edge);
  });
  std::size_t first = 0;
  for (std::uint32_t region = 0; region < diagram.site.size(); ++region) {
    std::size_t end = first;
    while (end < sides.size() && sides[end].region == region) ++end;
    const std::span<EdgeSide> own = std::span(sides).subspan(first, end - first);
    const auto [kind, index] = diagram.site[region];
    const std::uint32_t corner = kind == Site::Kind::Wall ? plan.next[index] : index;
    link(plan, own, find_vertex_at(diagram, own, plan.vertex[corner]));
    diagram.region_first.push_back(static_cast<std::uint32_t>(first));
    first = end;
  }
  diagram.region_first.push_back(static_cast<std::uint32_t>(sides.size()));
  for (const EdgeSide& side : sides) diagram.region_edge.push_back(side.edge);
}

}  // namespace

VoronoiDiagram voronoi_diagram(const FloorPlan& plan) {
  VoronoiDiagram diagram;
  const SiteGraph graph = site_graph(plan);
  diagram.site = make_sites(plan, graph.reflex_corner);
  const EdgeCollector collector(plan, diagram.site, graph);
  add_vertices_and_edges(plan, collector, diagram);
  add_regions(plan, diagram);
  return diagram;
}

}  // namespace docent::floor
