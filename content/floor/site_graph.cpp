#include "content/floor/site_graph.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>
#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "content/content_error.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/model/none.h"

namespace docent::floor {
namespace {

using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
using Doubles = CGAL::Simple_cartesian<double>;
// Mended walls meet at their ends only, so the variant without intersections is complete. Where the
// filter fails (walls of a regular plan are often equally far), numbers without division are three
// times as fast as CGAL's default, rationals.
using Exact = CGAL::Simple_cartesian<CGAL::internal::Exact_ring_selector<double>::Type>;
using FilteredTraits = CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<
    Doubles, CGAL::Field_with_sqrt_tag, Exact, CGAL::Integral_domain_without_division_tag>;

Predicates::Point_2 exact_point(const Doubles::Point_2& p) {
  return {p.x(), p.y()};
}

/// How two sites lie to each other is asked most often of all, and mostly of sites that have at
/// most an end in common, which the graph takes for apart. Those are told by the signs that
/// orientations have, without intervals; the rest is left to CGAL.
struct ArrangementType : FilteredTraits::Arrangement_type_2 {
  using Base = FilteredTraits::Arrangement_type_2;
  using Site = FilteredTraits::Site_2;

  result_type operator()(const Site& p, const Site& q) const {
    const bool apart = have_separate_boxes(p, q) || (p.is_segment() && lies_beside(p, q)) ||
                       (q.is_segment() && lies_beside(q, p));
    return apart ? Base::DISJOINT : Base::operator()(p, q);
  }

 private:
  using Point = Doubles::Point_2;
  static const Point& start(const Site& s) { return s.is_point() ? s.point() : s.source(); }
  static const Point& end(const Site& s) { return s.is_point() ? s.point() : s.target(); }

  static bool have_separate_boxes(const Site& p, const Site& q) {
    const Point &a = start(p), &b = end(p), &c = start(q), &d = end(q);
    return std::max(a.x(), b.x()) < std::min(c.x(), d.x()) ||
           std::max(c.x(), d.x()) < std::min(a.x(), b.x()) ||
           std::max(a.y(), b.y()) < std::min(c.y(), d.y()) ||
           std::max(c.y(), d.y()) < std::min(a.y(), b.y());
  }

  /// Is q on one side of the line through p, but for an end that may be one of p's?
  static bool lies_beside(const Site& p, const Site& q) {
    const CGAL::Orientation c = side_of(p, start(q)), d = side_of(p, end(q));
    if (c != CGAL::COLLINEAR && d != CGAL::COLLINEAR) return c == d;
    const auto is_clear = [&p](CGAL::Orientation side, const Point& point) {
      return side != CGAL::COLLINEAR || point == p.source() || point == p.target();
    };
    return is_clear(c, start(q)) && is_clear(d, end(q)) && (c != d || q.is_point());
  }
  static CGAL::Orientation side_of(const Site& p, const Point& point) {
    return CGAL::orientation(exact_point(p.source()), exact_point(p.target()), exact_point(point));
  }
};

struct Traits : FilteredTraits {
  using Arrangement_type_2 = ArrangementType;
  [[nodiscard]] Arrangement_type_2 arrangement_type_2_object() const { return {}; }
};

/// A vertex or a face of the graph with a number of ours.
template <typename Base>
struct Numbered : Base {
  using Base::Base;
  template <typename Structure>
  struct Rebind_TDS {  // NOLINT(readability-identifier-naming): CGAL asks for it by this name.
    using Other = Numbered<typename Base::template Rebind_TDS<Structure>::Other>;
  };
  std::uint32_t number = none;
};

using Storage = CGAL::Segment_Delaunay_graph_storage_traits_2<Traits>;
using Graph = CGAL::Segment_Delaunay_graph_2<
    Traits, Storage,
    CGAL::Triangulation_data_structure_2<
        Numbered<CGAL::Segment_Delaunay_graph_vertex_base_2<Storage>>,
        Numbered<CGAL::Segment_Delaunay_graph_face_base_2<Traits>>>,
    CGAL::Tag_true>;

std::vector<std::uint32_t> find_reflex_corners(const FloorPlan& plan) {
  std::vector<std::uint32_t> previous(plan.vertex.size(), none);
  for (std::uint32_t i = 0; i < plan.next.size(); ++i) previous[plan.next[i]] = i;
  const auto point = [&](std::uint32_t i) {
    return Predicates::Point_2(plan.vertex[i].x, plan.vertex[i].y);
  };
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i)
    if (CGAL::orientation(point(previous[i]), point(i), point(plan.next[i])) != CGAL::LEFT_TURN)
      corners.push_back(i);
  return corners;
}

struct RingBox {
  Vec2 low{}, high{};
};

RingBox box_of(std::span<const Vec2> ring) {
  RingBox box{ring.front(), ring.front()};
  for (const Vec2 vertex : ring) {
    box.low = glm::min(box.low, vertex);
    box.high = glm::max(box.high, vertex);
  }
  return box;
}

bool holds(const RingBox& box, Vec2 point) {
  return glm::min(box.low, point) == box.low && glm::max(box.high, point) == box.high;
}

std::span<const Vec2> vertices_of(const FloorPlan& plan, const Ring& ring) {
  return std::span(plan.vertex).subspan(ring.first, ring.count);
}

/// Are all walls of a ring seen from behind here?
bool is_behind(std::span<const Vec2> ring, Vec2 point) {
  const auto exact = [](Vec2 p) { return Predicates::Point_2(p.x, p.y); };
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (CGAL::orientation(exact(ring[i]), exact(ring[(i + 1) % ring.size()]), exact(point)) !=
        CGAL::RIGHT_TURN)
      return false;
  return true;
}

/// A point within each obstacle that has one from which all its walls are seen.
///
/// All walls of a round column, or of a square case, are equally far from its middle, and to find
/// out in which order takes exact numbers by the thousands, for a vertex that nobody asks for. A
/// site of its own in the middle leaves nothing to compare there. Every point of the floor has a
/// wall between itself and the middle, so the diagram on the floor stays what it is.
std::vector<Vec2> find_middles(const FloorPlan& plan) {
  std::vector<RingBox> floors;
  for (const Ring& ring : plan.ring)
    if (signed_area(vertices_of(plan, ring)) > 0) floors.push_back(box_of(vertices_of(plan, ring)));
  std::vector<Vec2> middles;
  for (const Ring& ring : plan.ring) {
    const std::span<const Vec2> vertices = vertices_of(plan, ring);
    const Vec2 offset =
        std::accumulate(vertices.begin(), vertices.end(), Vec2{},
                        [&](Vec2 sum, Vec2 vertex) { return sum + (vertex - vertices.front()); });
    const Vec2 middle = vertices.front() + offset / static_cast<double>(vertices.size());
    const RingBox box = box_of(vertices);
    const auto is_floor_within = [&](const RingBox& floor) {
      return holds(floor, middle) && holds(box, floor.low) && holds(box, floor.high);
    };
    if (is_behind(vertices, middle) && std::ranges::none_of(floors, is_floor_within))
      middles.push_back(middle);
  }
  return middles;
}

/// The vertices along a space-filling curve, so that each is inserted near the one before.
std::vector<std::size_t> spatial_order(const std::vector<Doubles::Point_2>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  using Order =
      CGAL::Spatial_sort_traits_adapter_2<Doubles,
                                          CGAL::Pointer_property_map<Doubles::Point_2>::const_type>;
  CGAL::spatial_sort(order.begin(), order.end(), Order(CGAL::make_property_map(points)));
  return order;
}

Graph make_graph(const FloorPlan& plan, const std::vector<std::uint32_t>& reflex_corners) {
  std::vector<Doubles::Point_2> points;
  for (const Vec2 vertex : plan.vertex) points.emplace_back(vertex.x, vertex.y);
  for (const Vec2 middle : find_middles(plan)) points.emplace_back(middle.x, middle.y);
  const std::vector<std::size_t> order = spatial_order(points);

  Graph graph;
  std::vector<Graph::Vertex_handle> corner(points.size());
  Graph::Vertex_handle near{};
  for (const std::size_t i : order) near = corner[i] = graph.insert(points[i], near);
  const auto walls = static_cast<std::uint32_t>(plan.next.size());
  for (std::uint32_t i = 0; i < walls; ++i) corner[i]->number = walls + i;
  for (const std::uint32_t i : reflex_corners) corner[i]->number = walls + i;

  for (const std::size_t i : order) {
    if (i >= walls) continue;  // A middle.
    const Graph::Vertex_handle wall = graph.insert(corner[i], corner[plan.next[i]]);
    // A wall that crosses another is left out with no more than a word on standard error.
    if (wall == Graph::Vertex_handle() || !wall->is_segment() || wall->number != none)
      throw content::ContentError(plan.name, 0, 0, "crossing-walls",
                                  "the walls of a floor cross or overlap");
    wall->number = static_cast<std::uint32_t>(i);
  }
  return graph;
}

}  // namespace

SiteGraph site_graph(const FloorPlan& plan) {
  SiteGraph result;
  result.reflex_corner = find_reflex_corners(plan);
  Graph graph = make_graph(plan, result.reflex_corner);
  std::uint32_t count = 0;
  for (auto face = graph.finite_faces_begin(); face != graph.finite_faces_end(); ++face)
    face->number = count++;
  result.triangle.reserve(count);
  for (auto face = graph.finite_faces_begin(); face != graph.finite_faces_end(); ++face) {
    SiteTriangle& triangle = result.triangle.emplace_back();
    for (int i = 0; i < 3; ++i) {
      triangle.site[static_cast<std::size_t>(i)] = face->vertex(i)->number;
      triangle.neighbour[static_cast<std::size_t>(i)] = face->neighbor(i)->number;
    }
  }
  return result;
}

}  // namespace docent::floor
