#include "runtime/path/offset_curve.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "runtime/path/flatten.h"
#include "runtime/path/floor_map.h"

namespace docent {

LevelCurve::LevelCurve(const MedialAxisMap& map, double distance) : map_(map), distance_(distance) {
  const VoronoiDiagram& voronoi = map.diagram();
  const FloorPlan& plan = map.floor().plan;
  std::vector<std::uint32_t> previous(plan.vertex.size());
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) previous[plan.next[i]] = i;
  corner_.resize(voronoi.site.size());
  for (std::size_t s = 0; s < voronoi.site.size(); ++s) {
    const Site& site = voronoi.site[s];
    if (site.kind == Site::Kind::Corner)
      corner_[s] = reflex_corner(plan, previous[site.index], site.index)
                       .value_or(ReflexCorner{.vertex = site.index});
  }
  find_crossings();
  find_pieces();
}

bool LevelCurve::is_wall(std::uint32_t site) const noexcept {
  return map_.diagram().site[site].kind == Site::Kind::Wall;
}

void LevelCurve::find_crossings() {
  const VoronoiDiagram& voronoi = map_.diagram();
  edge_first_.reserve(voronoi.edge.size() + 1);
  for (std::uint32_t e = 0; e < voronoi.edge.size(); ++e) {
    edge_first_.push_back(static_cast<std::uint32_t>(crossing_.size()));
    const EdgeCurve& curve = map_.curve(e);
    // Vertices are judged by their own stored clearance, so that all their edges agree. A passage
    // of exactly twice the distance is not passed: what would connect there has no area.
    const double above_distance = distance_ + touching;
    const auto cross_between = [&](double a, double b, bool a_above, bool b_above) {
      if (a_above != b_above)
        crossing_.push_back({e, curve.place_of_clearance(distance_, a, b), b_above});
    };
    const bool from_above = voronoi.clearance[voronoi.edge[e].from] > above_distance;
    const bool to_above = voronoi.clearance[voronoi.edge[e].to] > above_distance;
    const double lowest = curve.lowest_place();
    if (lowest == curve.begin() || lowest == curve.end()) {
      cross_between(curve.begin(), curve.end(), from_above, to_above);
    } else {
      // Never above an end that is not: rounding must not make a third crossing.
      const bool above = curve.clearance_at(lowest) > above_distance && from_above && to_above;
      cross_between(curve.begin(), lowest, from_above, above);
      cross_between(lowest, curve.end(), above, to_above);
    }
  }
  edge_first_.push_back(static_cast<std::uint32_t>(crossing_.size()));
}

/// Round a region, counter-clockwise, the boundary rises past the distance and falls below it in
/// turn; between a rise and the fall after it the region reaches beyond the distance, and there the
/// curve runs from the fall's place back to the rise's, the wall on its right.
void LevelCurve::find_pieces() {
  struct Passed {
    std::uint32_t crossing;
    bool rises;
  };
  const VoronoiDiagram& voronoi = map_.diagram();
  piece_from_.assign(crossing_.size(), MedialAxisMap::none);
  std::vector<Passed> passed;
  for (std::uint32_t site = 0; site + 1 < voronoi.region_first.size(); ++site) {
    passed.clear();
    for (std::uint32_t k = voronoi.region_first[site]; k < voronoi.region_first[site + 1]; ++k) {
      const std::uint32_t e = voronoi.region_edge[k];
      const std::uint32_t first = edge_first_[e], end = edge_first_[e + 1];
      if (voronoi.edge[e].left == site)
        for (std::uint32_t c = first; c < end; ++c) passed.push_back({c, crossing_[c].rises});
      else
        for (std::uint32_t c = end; c-- > first;) passed.push_back({c, !crossing_[c].rises});
    }
    for (std::size_t i = 0; i < passed.size(); ++i) {
      const Passed& fall = passed[(i + 1) % passed.size()];
      if (!passed[i].rises || fall.rises) continue;
      const std::uint32_t from = fall.crossing, to = passed[i].crossing;
      const auto place = [&](std::uint32_t c) {
        return place_of(site, map_.curve(crossing_[c].voronoi_edge).point_at(crossing_[c].at));
      };
      piece_from_[from] = static_cast<std::uint32_t>(piece_.size());
      piece_.push_back({site, from, to, place(from), place(to)});
    }
  }
}

double LevelCurve::place_of(std::uint32_t site, Vec2 point) const {
  if (!is_wall(site)) return corner_[site].angle_of(point - corner_[site].position);
  const std::uint32_t wall = map_.diagram().site[site].index;
  const Vec2 a = wall_start(map_.floor().plan, wall), b = wall_end(map_.floor().plan, wall);
  return dot(point - a, glm::normalize(b - a));
}

Vec2 LevelCurve::point_at(std::uint32_t site, double place) const {
  if (!is_wall(site)) return corner_[site].point_at(place, distance_);
  const std::uint32_t wall = map_.diagram().site[site].index;
  const Vec2 a = wall_start(map_.floor().plan, wall), b = wall_end(map_.floor().plan, wall);
  const Vec2 along = glm::normalize(b - a);
  return a + place * along + distance_ * left_of(along);
}

double LevelCurve::length_between(std::uint32_t site, double a, double b) const noexcept {
  return (is_wall(site) ? 1 : distance_) * std::abs(b - a);
}

void LevelCurve::append_points(std::uint32_t site, double a, double b,
                               std::vector<Vec2>& points) const {
  if (!is_wall(site)) return append_arc(corner_[site], distance_, a, b, points);
  append_point(point_at(site, a), points);
  append_point(point_at(site, b), points);
}

double LevelCurve::area_between(std::uint32_t site, double a, double b, Vec2 origin) const {
  const Vec2 p = point_at(site, a) - origin, q = point_at(site, b) - origin;
  if (is_wall(site)) return cross(p, q) / 2;
  return (cross(corner_[site].position - origin, q - p) + distance_ * distance_ * (b - a)) / 2;
}

namespace {

OffsetRing wall_ring(const FloorPlan& plan, const Ring& ring) {
  OffsetRing made;
  for (std::uint32_t i = ring.first; i < ring.first + ring.count; ++i) {
    const Vec2 a = wall_start(plan, i), b = wall_end(plan, i);
    made.points.push_back(a);
    made.length += glm::length(b - a);
    made.area += cross(a - plan.vertex[ring.first], b - plan.vertex[ring.first]) / 2;
  }
  return made;
}

/// Follows the curve from one piece until it closes; gives its pieces.
std::vector<std::uint32_t> follow(const LevelCurve& curve, std::uint32_t first,
                                  std::vector<bool>& followed) {
  std::vector<std::uint32_t> pieces;
  for (std::uint32_t p = first; p != MedialAxisMap::none && !followed[p];
       p = curve.piece_from(curve.pieces()[p].to)) {
    followed[p] = true;
    pieces.push_back(p);
  }
  return pieces;
}

/// Gives places that coincide the same number: where a curve touches itself. Crossings beside a
/// place that the curve just touches are known to the square root of the rounding only.
std::vector<std::uint32_t> number_places(const std::vector<Vec2>& points) {
  constexpr double same_place = 1e-6;
  std::vector<std::uint32_t> order(points.size()), number(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::iota(number.begin(), number.end(), 0U);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair(points[i].x, i); });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i; j-- > 0;) {
      const Vec2 apart = points[order[i]] - points[order[j]];
      if (apart.x > same_place) break;
      if (std::abs(apart.y) <= same_place) number[order[i]] = number[order[j]];
    }
  return number;
}

/// Splits a closed row of pieces where it touches itself, so that no ring passes a point twice: two
/// holes that touch stay two.
std::vector<std::vector<std::uint32_t>> split_where_touching(
    const LevelCurve& curve, const std::vector<std::uint32_t>& pieces) {
  std::vector<Vec2> begins;
  begins.reserve(pieces.size());
  for (const std::uint32_t p : pieces)
    begins.push_back(curve.point_at(curve.pieces()[p].site, curve.pieces()[p].begin));
  const auto place = number_places(begins);
  std::vector<std::vector<std::uint32_t>> rings;
  std::vector<std::size_t> open;                    // pieces not yet in a ring, in order
  std::vector<bool> visited(pieces.size(), false);  // per place: does an open piece begin there?
  for (std::size_t i = 0; i <= pieces.size(); ++i) {
    const std::uint32_t here = place[i % pieces.size()];
    if (visited[here]) {
      std::vector<std::uint32_t> ring;
      while (visited[here]) {
        ring.push_back(pieces[open.back()]);
        visited[place[open.back()]] = false;
        open.pop_back();
      }
      std::ranges::reverse(ring);
      rings.push_back(std::move(ring));
    }
    open.push_back(i % pieces.size());
    visited[here] = true;
  }
  return rings;
}

OffsetRing make_ring(const LevelCurve& curve, const std::vector<std::uint32_t>& pieces) {
  OffsetRing ring;
  const LevelPiece& first = curve.pieces()[pieces.front()];
  const Vec2 origin = curve.point_at(first.site, first.begin);
  for (const std::uint32_t p : pieces) {
    const LevelPiece& piece = curve.pieces()[p];
    ring.length += curve.length_between(piece.site, piece.begin, piece.end);
    ring.area += curve.area_between(piece.site, piece.begin, piece.end, origin);
    curve.append_points(piece.site, piece.begin, piece.end, ring.points);
  }
  if (ring.points.size() > 1 && ring.points.front() == ring.points.back()) ring.points.pop_back();
  return ring;
}

}  // namespace

OffsetCurve offset_curve(const MedialAxisMap& map, double distance) {
  OffsetCurve made{.distance = distance};
  if (!(distance >= 0) || !std::isfinite(distance)) return made;
  if (distance == 0) {
    for (const Ring& ring : map.floor().plan.ring)
      made.rings.push_back(wall_ring(map.floor().plan, ring));
  } else {
    const LevelCurve curve(map, distance);
    std::vector<bool> followed(curve.pieces().size(), false);
    for (std::uint32_t p = 0; p < curve.pieces().size(); ++p)
      if (!followed[p])
        for (const auto& pieces : split_where_touching(curve, follow(curve, p, followed)))
          made.rings.push_back(make_ring(curve, pieces));
  }
  for (const OffsetRing& ring : made.rings) {
    ++(ring.area > 0 ? made.components : made.holes);
    made.area += ring.area;
    made.perimeter += ring.length;
  }
  return made;
}

OffsetCurve offset_curve(const FloorMap& map, double distance) {
  return offset_curve(map.medial_axis(), distance);
}

}  // namespace docent
