#include "content/scenery/plates.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <algorithm>
#include <cmath>

namespace docent::scenery {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct FaceInfo {
  bool seen = false;
  PlateKind region = PlateKind::Outside;
  std::uint32_t area = 0;
};
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure =
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
using Face = Triangulation::Face_handle;

using Polygon = std::vector<Vec2>;

Polygon ring_of(const FloorPlan& plan, const Ring& ring) {
  const auto first = plan.vertex.begin() + ring.first;
  return {first, first + ring.count};
}

Vec2 direction(Vec2 from, Vec2 to) {
  const Vec2 d = to - from;
  const double length = std::hypot(d.x, d.y);
  return length > 0 ? d / length : Vec2{1, 0};
}

/// The ring moved to its right by `distance`, which is away from the interior. It may cross itself:
/// what counts is its winding number (Chen and McMains 2005, polygon offsetting by computing
/// winding numbers). Corners are mitred up to twice the distance, then cut off.
Polygon moved_right(const Polygon& ring, double distance) {
  Polygon out;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = direction(ring[(i + n - 1) % n], ring[i]);
    const Vec2 on = direction(ring[i], ring[(i + 1) % n]);
    const Vec2 normal_in = -left_of(in);
    const Vec2 normal_on = -left_of(on);
    const double cosine = 1 + dot(normal_in, normal_on);
    constexpr double sharpest = 0.5;  // mitre length is distance * sqrt(2 / cosine): 2 distances
    if (cosine >= sharpest) {
      out.push_back(ring[i] + (normal_in + normal_on) * (distance / cosine));
    } else {
      out.push_back(ring[i] + normal_in * distance);
      out.push_back(ring[i] + normal_on * distance);
    }
  }
  return out;
}

/// How often a closed polygon goes round the point, counter-clockwise.
int winding(const Polygon& polygon, Vec2 p) {
  int turns = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i];
    const Vec2 b = polygon[(i + 1) % polygon.size()];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const double side = cross(b - a, p - a);
    if (a.y <= p.y && side > 0) ++turns;
    if (b.y <= p.y && side < 0) --turns;
  }
  return turns;
}

/// Cuts an edge into pieces of 0.15, 0.3, 0.6, ... 0.9 m from either end, since light changes most
/// in corners.
void insert_in_pieces(Triangulation& triangulation, Vec2 a, Vec2 b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  std::vector<double> cuts;
  double piece = 0.15;
  constexpr double longest_piece = 0.9;
  for (double at = piece; at < length / 2; at += piece) {
    cuts.push_back(at);
    piece = std::min(2 * piece, longest_piece);
  }
  std::vector<double> all{0};
  all.insert(all.end(), cuts.begin(), cuts.end());
  for (auto cut = cuts.rbegin(); cut != cuts.rend(); ++cut) all.push_back(length - *cut);
  all.push_back(length);
  const auto point = [&](double at) {
    const Vec2 p = at >= length ? b : a + (b - a) * (at / std::max(length, 1e-12));
    return Kernel::Point_2(p.x, p.y);
  };
  for (std::size_t i = 0; i + 1 < all.size(); ++i)
    if (all[i + 1] - all[i] > 1e-6)
      triangulation.insert_constraint(point(all[i]), point(all[i + 1]));
}

struct Outlines {
  std::vector<Polygon> rings;
  std::vector<Polygon> backs;  ///< Of the rings with walls, `thickness` behind them.
  std::vector<Polygon> paved;  ///< Paved areas, grown to the middle of a doorway.
};

class Classifier {
 public:
  Classifier(const Outlines& outlines, const std::vector<bool>& furniture)
      : outlines_(outlines), furniture_(furniture) {}

  FaceInfo at(Vec2 p) const {
    int inside = 0;
    for (const Polygon& ring : outlines_.rings) inside += winding(ring, p);
    if (inside > 0) return {true, PlateKind::Floor, area_at(p)};
    for (std::uint32_t r = 0; r < outlines_.rings.size(); ++r)
      if (furniture_[r] && winding(outlines_.rings[r], p) != 0)
        return {true, PlateKind::Hole, area_at(p)};
    int solid = 0;
    for (const Polygon& back : outlines_.backs) solid += winding(back, p);
    return {true, solid > 0 ? PlateKind::Wall : PlateKind::Outside, 0};
  }

 private:
  std::uint32_t area_at(Vec2 p) const {
    for (std::uint32_t a = 0; a < outlines_.paved.size(); ++a)
      if (winding(outlines_.paved[a], p) > 0) return a + 1;
    return 0;
  }

  const Outlines& outlines_;
  const std::vector<bool>& furniture_;
};

Vec2 corner_of(Face face, int i) {
  const auto& p = face->vertex(i)->point();
  return {p.x(), p.y()};
}

double area_of(Face face) {
  return cross(corner_of(face, 1) - corner_of(face, 0), corner_of(face, 2) - corner_of(face, 0)) /
         2;
}

/// The faces that can be reached from `seed` without crossing a constraint. `is_open` tells whether
/// they reach to infinity.
std::vector<Face> component_of(const Triangulation& triangulation, Face seed, bool& is_open) {
  std::vector<Face> component(1, seed);
  seed->info().seen = true;
  is_open = false;
  for (std::size_t i = 0; i < component.size(); ++i) {
    const Face face = component[i];
    for (int side = 0; side < 3; ++side) {
      const Face other = face->neighbor(side);
      if (face->is_constrained(side)) continue;
      is_open = is_open || triangulation.is_infinite(other);
      if (triangulation.is_infinite(other) || other->info().seen) continue;
      other->info().seen = true;
      component.push_back(other);
    }
  }
  return component;
}

/// Gives every face the region of its component, whose largest face is asked for all. A small
/// pocket between walls is filled: nobody sees a shaft in an architect's model.
void classify(const Triangulation& triangulation, const Classifier& classifier) {
  constexpr double largest_pocket = 6;  // square metres
  for (Face seed : triangulation.finite_face_handles()) {
    if (seed->info().seen) continue;
    bool is_open = false;
    const std::vector<Face> component = component_of(triangulation, seed, is_open);
    Face largest = seed;
    double area = 0;
    for (Face face : component) {
      area += area_of(face);
      if (area_of(face) > area_of(largest)) largest = face;
    }
    const Vec2 middle =
        (corner_of(largest, 0) + corner_of(largest, 1) + corner_of(largest, 2)) / 3.0;
    FaceInfo info = classifier.at(middle);
    if (info.region == PlateKind::Outside && !is_open && area < largest_pocket)
      info.region = PlateKind::Wall;
    for (Face face : component) face->info() = info;
  }
}

}  // namespace

Plates divide(const FloorPlan& plan, const std::vector<bool>& furniture, double thickness,
              std::span<const PavedArea> paving) {
  Outlines outlines;
  Triangulation triangulation;
  const auto insert = [&](const Polygon& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      insert_in_pieces(triangulation, polygon[i], polygon[(i + 1) % polygon.size()]);
  };
  for (std::size_t r = 0; r < plan.ring.size(); ++r) {
    outlines.rings.push_back(ring_of(plan, plan.ring[r]));
    insert(outlines.rings.back());
    if (furniture[r]) continue;
    outlines.backs.push_back(moved_right(outlines.rings.back(), thickness));
    insert(outlines.backs.back());
  }
  for (const PavedArea& area : paving) {
    outlines.paved.push_back(moved_right(area.outline, thickness / 2));
    insert(outlines.paved.back());
  }
  classify(triangulation, Classifier(outlines, furniture));

  Plates plates;
  const auto region_of = [&](Face face) {
    return triangulation.is_infinite(face) ? PlateKind::Outside : face->info().region;
  };
  for (Face face : triangulation.finite_face_handles()) {
    if (region_of(face) == PlateKind::Outside) continue;
    plates.plates.push_back({{corner_of(face, 0), corner_of(face, 1), corner_of(face, 2)},
                             face->info().region,
                             face->info().area});
    if (region_of(face) != PlateKind::Wall) continue;
    for (int side = 0; side < 3; ++side) {
      const PlateKind beyond = region_of(face->neighbor(side));
      if (beyond == PlateKind::Wall || beyond == PlateKind::Hole) continue;
      plates.wall_edges.push_back(
          {corner_of(face, Triangulation::ccw(side)), corner_of(face, Triangulation::cw(side))});
    }
  }
  return plates;
}

}  // namespace docent::scenery
