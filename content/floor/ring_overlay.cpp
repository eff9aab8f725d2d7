#include "content/floor/ring_overlay.h"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "runtime/model/geometry/segment.h"
#include "runtime/model/none.h"

namespace docent::floor {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;

/// The side of a ring that an edge of the arrangement is a piece of.
struct Cover {
  std::uint32_t ring = 0;
  std::uint32_t side = 0;
  bool eastwards = false;  ///< Lexicographically ascending, CGAL's "left to right".
  bool operator==(const Cover&) const = default;
};

struct VertexMark {
  std::uint32_t input = none;  ///< Rank of the first input vertex here.
  std::uint32_t visits = 0;    ///< How often walls arrive here.
};
struct HalfedgeMark {
  bool wall_seen = false;
};
struct FaceMark {
  bool visited = false;
  bool enclosed = false;
};

using Segments = CGAL::Arr_segment_traits_2<Kernel>;
using Traits = CGAL::Arr_consolidated_curve_data_traits_2<Segments, Cover>;
using Dcel = CGAL::Arr_extended_dcel<Traits, VertexMark, HalfedgeMark, FaceMark>;
using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;
using Halfedge = Arrangement::Halfedge_handle;
using Face = Arrangement::Face_handle;
using Vertex = Arrangement::Vertex_handle;

double nearest_double(const Kernel::FT& number) {
  return CGAL::to_double(CGAL::exact(number));  // Not from the filter's interval.
}

Vec2 rounded(const Point& p) {
  return {nearest_double(p.x()), nearest_double(p.y())};
}

bool west_to_east(Vec2 a, Vec2 b) {
  return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

Point to_point(Vec2 p) {
  return {p.x, p.y};
}

/// Knows the input's vertices by their coordinates.
class VertexRanks {
 public:
  explicit VertexRanks(std::span<const OverlayRing> rings) {
    for (const OverlayRing& ring : rings)
      for (const Vec2 vertex : ring.vertex) {
        const auto rank = static_cast<std::uint32_t>(vertices_.size());
        first_.try_emplace(std::pair(vertex.x, vertex.y), rank);
        vertices_.push_back(vertex);
      }
  }
  [[nodiscard]] std::uint32_t find(const Point& point) const {
    // A point that is no pair of doubles is no vertex of the input, nor is its rounding.
    const Vec2 nearest = rounded(point);
    if (to_point(nearest) != point) return none;
    const auto found = first_.find(std::pair(nearest.x, nearest.y));
    return found == first_.end() ? none : found->second;
  }
  [[nodiscard]] Vec2 operator[](std::uint32_t rank) const { return vertices_[rank]; }

 private:
  std::vector<Vec2> vertices_;
  std::map<std::pair<double, double>, std::uint32_t> first_;
};

Arrangement arrange(std::span<const OverlayRing> rings) {
  std::vector<Traits::Curve_2> curves;
  for (std::uint32_t r = 0; r < rings.size(); ++r) {
    const auto& vertex = rings[r].vertex;
    for (std::uint32_t i = 0; i < vertex.size(); ++i) {
      const Vec2 a = vertex[i], b = vertex[(i + 1) % vertex.size()];
      if (a == b) continue;
      curves.emplace_back(Segments::Curve_2(to_point(a), to_point(b)),
                          Cover{.ring = r, .side = i, .eastwards = west_to_east(a, b)});
    }
  }
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  return arrangement;
}

/// How often each ring winds about the current face, and so whether it is enclosed. Crossing an
/// edge changes only the rings that run along it.
class Winding {
 public:
  Winding(std::span<const OverlayRing> rings, Fill fill)
      : rings_(rings), fill_(fill), winding_(rings.size(), 0) {
    std::uint32_t polygons = 0;
    for (const OverlayRing& ring : rings) polygons = std::max(polygons, ring.polygon + 1);
    in_outer_.resize(polygons, 0);
    in_holes_.resize(polygons, 0);
  }

  /// Steps over an edge, from the face on its left to the one on its right.
  void cross(const Halfedge& edge) {
    const bool eastwards = edge->direction() == CGAL::ARR_LEFT_TO_RIGHT;
    for (auto cover = edge->curve().data().begin(); cover != edge->curve().data().end(); ++cover)
      change(cover->ring, cover->eastwards == eastwards ? -1 : 1);
  }

  [[nodiscard]] bool enclosed() const {
    return fill_ == Fill::LeftOfRings ? total_ > 0 : open_polygons_ > 0;
  }

 private:
  void change(std::uint32_t ring, int by) {
    total_ += by;
    const bool was_inside = winding_[ring] != 0;
    winding_[ring] += by;
    const bool is_inside = winding_[ring] != 0;
    if (was_inside == is_inside) return;
    const std::uint32_t polygon = rings_[ring].polygon;
    open_polygons_ -= is_open(polygon) ? 1 : 0;
    (rings_[ring].hole ? in_holes_ : in_outer_)[polygon] += is_inside ? 1 : -1;
    open_polygons_ += is_open(polygon) ? 1 : 0;
  }
  [[nodiscard]] bool is_open(std::uint32_t polygon) const {
    return in_outer_[polygon] > 0 && in_holes_[polygon] == 0;
  }

  std::span<const OverlayRing> rings_;
  Fill fill_;
  std::vector<int> winding_;   ///< Per ring.
  std::vector<int> in_outer_;  ///< Per polygon: outer rings that wind about the face.
  std::vector<int> in_holes_;  ///< Per polygon: holes that do.
  int open_polygons_ = 0;
  int total_ = 0;
};

template <typename Function>
void for_each_edge_of(const Face& face, const Function& function) {
  const auto go_round = [&](const Arrangement::Ccb_halfedge_circulator& begin) {
    auto edge = begin;
    do function(Halfedge(edge));
    while (++edge != begin);
  };
  for (auto ccb = face->outer_ccbs_begin(); ccb != face->outer_ccbs_end(); ++ccb) go_round(*ccb);
  for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb) go_round(*ccb);
}

/// Walks over all faces from the outside in, one edge at a time, and back the way it came.
void mark_enclosed_faces(Arrangement& arrangement, Winding winding) {
  struct Step {
    Halfedge edge;
    bool back;
  };
  std::vector<Step> steps;
  const auto enter = [&](const Face& face) {
    face->set_data({.visited = true, .enclosed = winding.enclosed()});
    for_each_edge_of(face, [&](const Halfedge& edge) {
      if (!edge->twin()->face()->data().visited) steps.push_back({edge, false});
    });
  };
  enter(arrangement.unbounded_face());
  while (!steps.empty()) {
    const auto [edge, back] = steps.back();
    steps.pop_back();
    if (back) {
      winding.cross(edge->twin());
    } else if (!edge->twin()->face()->data().visited) {
      winding.cross(edge);
      steps.push_back({edge, true});
      enter(edge->twin()->face());
    }
  }
}

bool is_wall(const Halfedge& edge) {
  return edge->face()->data().enclosed && !edge->twin()->face()->data().enclosed;
}

/// The wall after this one, round the same wedge of the enclosed part.
Halfedge next_wall(const Halfedge& wall) {
  Halfedge next = wall->next();
  while (!is_wall(next)) next = next->twin()->next();
  return next;
}

/// Does a b c run straight on, as far as doubles can tell? A bend that is smaller than that is the
/// rest of a rounding, and no disc that touches both its sides can be computed.
bool is_straight(Vec2 a, Vec2 b, Vec2 c) {
  const double largest = std::max(
      {std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y), std::abs(c.x), std::abs(c.y)});
  return dot(b - a, c - b) > 0 &&
         distance_to_segment(b, a, c) <= 2 * std::numeric_limits<double>::epsilon() * largest;
}

/// A vertex may go where the wall runs straight on and no other wall needs it.
bool is_needed(const Halfedge& wall, const Halfedge& next) {
  if (wall->target()->data().visits > 1) return true;
  const Point &a = wall->source()->point(), &b = wall->target()->point(),
              &c = next->target()->point();
  return !CGAL::collinear(a, b, c) && !is_straight(rounded(a), rounded(b), rounded(c));
}

struct Loop {
  std::uint32_t first_rank = none;
  std::vector<Vec2> vertex;
};

/// The loop of walls through `start`, which are marked as seen.
Loop follow_wall(const Halfedge& start, const VertexRanks& ranks, bool& adds_vertices) {
  std::vector<std::pair<std::uint32_t, Vec2>> corners;
  Halfedge wall = start;
  do {
    wall->set_data({.wall_seen = true});
    const Halfedge next = next_wall(wall);
    if (is_needed(wall, next)) {
      const std::uint32_t rank = wall->target()->data().input;
      adds_vertices |= rank == none;
      const Point& p = wall->target()->point();
      corners.emplace_back(rank, rank == none ? rounded(p) : ranks[rank]);
    }
    wall = next;
  } while (wall != start);

  const auto by_rank_then_place = [](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    return west_to_east(a.second, b.second);
  };
  std::ranges::rotate(corners, std::ranges::min_element(corners, by_rank_then_place));
  Loop loop{.first_rank = corners.front().first, .vertex = {}};
  for (const auto& [rank, vertex] : corners) loop.vertex.push_back(vertex);
  return loop;
}

std::vector<std::vector<Vec2>> trace_walls(Arrangement& arrangement, const VertexRanks& ranks,
                                           bool& adds_vertices) {
  for (auto vertex = arrangement.vertices_begin(); vertex != arrangement.vertices_end(); ++vertex)
    vertex->set_data({.input = ranks.find(vertex->point()), .visits = 0});
  for (auto edge = arrangement.halfedges_begin(); edge != arrangement.halfedges_end(); ++edge)
    if (is_wall(edge)) ++edge->target()->data().visits;

  std::vector<Loop> loops;
  for (auto edge = arrangement.halfedges_begin(); edge != arrangement.halfedges_end(); ++edge)
    if (is_wall(edge) && !edge->data().wall_seen)
      loops.push_back(follow_wall(edge, ranks, adds_vertices));
  std::ranges::sort(loops, [](const Loop& a, const Loop& b) {
    if (a.first_rank != b.first_rank) return a.first_rank < b.first_rank;
    return std::ranges::lexicographical_compare(a.vertex, b.vertex, west_to_east);
  });
  std::vector<std::vector<Vec2>> walls;
  for (Loop& loop : loops) walls.push_back(std::move(loop.vertex));
  return walls;
}

/// The covers of all edges that end in a vertex.
std::vector<Cover> covers_about(const Vertex& vertex) {
  std::vector<Cover> covers;
  auto edge = vertex->incident_halfedges();
  const auto begin = edge;
  do covers.insert(covers.end(), edge->curve().data().begin(), edge->curve().data().end());
  while (++edge != begin);
  std::ranges::sort(covers, {}, [](const Cover& c) { return std::pair(c.ring, c.side); });
  return covers;
}

/// Where rings meet: at a vertex that more than two pieces of sides arrive at, or one side twice
/// that another joins.
std::vector<RingContact> find_contacts(Arrangement& arrangement) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, RingContact> contacts;
  const auto note = [&](std::uint32_t a, std::uint32_t b, Vec2 at, bool crossing) {
    const auto [entry, added] = contacts.try_emplace({a, b}, RingContact{a, b, at, crossing});
    RingContact& contact = entry->second;
    if (west_to_east(at, contact.at)) contact.at = at;
    contact.crossing |= crossing;
  };
  for (auto vertex = arrangement.vertices_begin(); vertex != arrangement.vertices_end(); ++vertex) {
    const std::vector<Cover> covers = covers_about(vertex);
    if (covers.size() <= 2) continue;
    const Vec2 at = rounded(vertex->point());
    const bool crossing = vertex->data().input == none;
    for (std::size_t i = 0; i < covers.size();) {
      std::size_t end = i;
      while (end < covers.size() && covers[end].ring == covers[i].ring) ++end;
      if (end - i > 2) note(covers[i].ring, covers[i].ring, at, crossing);
      for (std::size_t j = end; j < covers.size(); ++j)
        if (covers[j].ring != covers[j - 1].ring || j == end)
          note(covers[i].ring, covers[j].ring, at, crossing);
      i = end;
    }
  }
  std::vector<RingContact> result;
  for (const auto& [pair, contact] : contacts) result.push_back(contact);
  return result;
}

}  // namespace

RingOverlay overlay(std::span<const OverlayRing> rings, Fill fill) {
  Arrangement arrangement = arrange(rings);
  mark_enclosed_faces(arrangement, Winding(rings, fill));
  RingOverlay result;
  result.walls = trace_walls(arrangement, VertexRanks(rings), result.adds_vertices);
  result.contacts = find_contacts(arrangement);
  result.bounds_any.assign(rings.size(), 0);
  for (auto edge = arrangement.halfedges_begin(); edge != arrangement.halfedges_end(); ++edge)
    if (is_wall(edge))
      for (auto cover = edge->curve().data().begin(); cover != edge->curve().data().end(); ++cover)
        result.bounds_any[cover->ring] = 1;
  return result;
}

}  // namespace docent::floor
