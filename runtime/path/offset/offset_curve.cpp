#include "runtime/path/offset/offset_curve.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "runtime/path/flatten.h"
#include "runtime/path/floor_map.h"
#include "runtime/path/index/stamped_array.h"

namespace docent::path {

bool LevelCurve::is_wall(std::uint32_t site) const noexcept {
  return map_->diagram().site[site].kind == Site::Kind::Wall;
}

LevelCurve::Crossings LevelCurve::crossings_of(std::uint32_t voronoi_edge) const noexcept {
  if (!map_->clearances(voronoi_edge).contains(distance_ + touching)) return {};
  const VoronoiDiagram& voronoi = map_->diagram();
  const VoronoiEdge& edge = voronoi.edge[voronoi_edge];
  const EdgeCurve& curve = map_->curve(voronoi_edge);
  // Vertices are judged by their own stored clearance, so that all their edges agree.
  const bool from_above = passes(voronoi.clearance[edge.from]);
  const bool to_above = passes(voronoi.clearance[edge.to]);
  Crossings crossings{.count = from_above && to_above ? 2U : 1U, .first_rises = !from_above};
  const double lowest = curve.lowest_place();
  crossings.at_pinch = map_->clearances(voronoi_edge).low >= distance_ - touching;
  if (crossings.at_pinch) {
    // All that comes there ends in the same place, which no rounding may draw apart.
    const double pinch = crossings.count == 2 ? lowest : from_above ? curve.end() : curve.begin();
    crossings.at = {pinch, pinch};
  } else if (crossings.count == 2) {
    crossings.at = {curve.place_of_clearance(distance_, curve.begin(), lowest),
                    curve.place_of_clearance(distance_, lowest, curve.end())};
  } else {
    crossings.at[0] = from_above ? curve.place_of_clearance(distance_, curve.begin(), lowest)
                                 : curve.place_of_clearance(distance_, lowest, curve.end());
  }
  return crossings;
}

Vec2 LevelCurve::point_at(LevelCrossing crossing) const noexcept {
  const std::uint32_t e = crossing / 2;
  return map_->curve(e).point_at(crossings_of(e).at[crossing % 2]);
}

/// The crossing after one as the boundary of a site's region is followed in a sense. There is
/// another one: whatever rises past the distance falls again.
LevelCurve::Found LevelCurve::next_crossing(LevelCrossing crossing, const Crossings& here,
                                            std::uint32_t site,
                                            bool counter_clockwise) const noexcept {
  const VoronoiDiagram& voronoi = map_->diagram();
  const std::uint32_t first = voronoi.region_first[site], end = voronoi.region_first[site + 1];
  std::uint32_t e = crossing / 2;
  // A loop passes the edges that have its site to their left in their own direction.
  const auto ascends = [&] { return (voronoi.edge[e].left == site) == counter_clockwise; };
  if (here.count == 2 && crossing % 2 == (ascends() ? 0U : 1U))
    return {crossing ^ 1U, here.at[1 - crossing % 2]};
  std::uint32_t k = map_->place_in_loop(e, site);
  for (std::uint32_t passed = first; passed < end; ++passed) {
    if (counter_clockwise)
      k = k + 1 == end ? first : k + 1;
    else
      k = k == first ? end - 1 : k - 1;
    e = voronoi.region_edge[k];
    const Crossings crossings = crossings_of(e);
    if (crossings.count == 0) continue;
    const std::uint32_t which = ascends() ? 0 : crossings.count - 1;
    return {2 * e + which, crossings.at[which]};
  }
  return {crossing, here.at[crossing % 2]};
}

LevelPiece LevelCurve::piece(std::uint32_t site, const Found& from,
                             const Found& to) const noexcept {
  const Vec2 first = point_at(from), last = point_at(to);
  return {site,  from.crossing, to.crossing, place_of(site, first), place_of(site, last),
          first, last};
}

/// Round a region, counter-clockwise, the boundary rises past the distance and falls below it in
/// turn; between a rise and the fall after it the region reaches beyond the distance, and there the
/// curve runs from the fall's place back to the rise's, the wall on its right.
LevelPiece LevelCurve::piece_from(LevelCrossing fall) const noexcept {
  const VoronoiEdge& edge = map_->diagram().edge[fall / 2];
  const Crossings here = crossings_of(fall / 2);
  const std::uint32_t site = rises(here, fall % 2) ? edge.right : edge.left;
  return piece(site, {fall, here.at[fall % 2]}, next_crossing(fall, here, site, false));
}

LevelPiece LevelCurve::piece_to(LevelCrossing rise) const noexcept {
  const VoronoiEdge& edge = map_->diagram().edge[rise / 2];
  const Crossings here = crossings_of(rise / 2);
  const std::uint32_t site = rises(here, rise % 2) ? edge.left : edge.right;
  return piece(site, next_crossing(rise, here, site, true), {rise, here.at[rise % 2]});
}

std::vector<LevelPiece> LevelCurve::pieces_in(std::uint32_t site) const {
  const VoronoiDiagram& voronoi = map_->diagram();
  std::vector<LevelPiece> pieces;
  if (site + 1 >= voronoi.region_first.size()) return pieces;
  for (std::uint32_t k = voronoi.region_first[site]; k < voronoi.region_first[site + 1]; ++k) {
    const std::uint32_t e = voronoi.region_edge[k];
    const Crossings crossings = crossings_of(e);
    for (std::uint32_t which = 0; which < crossings.count; ++which)
      if (rises(crossings, which) != (voronoi.edge[e].left == site))
        pieces.push_back(piece_from(2 * e + which));
  }
  return pieces;
}

double LevelCurve::place_of(std::uint32_t site, Vec2 point) const noexcept {
  if (!is_wall(site)) return map_->corner(site).angle_of(point - map_->corner(site).position);
  const std::uint32_t wall = map_->diagram().site[site].index;
  const Vec2 a = wall_start(map_->floor().plan, wall), b = wall_end(map_->floor().plan, wall);
  return dot(point - a, glm::normalize(b - a));
}

Vec2 LevelCurve::point_at(std::uint32_t site, double place) const noexcept {
  if (!is_wall(site)) return map_->corner(site).point_at(place, distance_);
  const std::uint32_t wall = map_->diagram().site[site].index;
  const Vec2 a = wall_start(map_->floor().plan, wall), b = wall_end(map_->floor().plan, wall);
  const Vec2 along = glm::normalize(b - a);
  return a + place * along + distance_ * left_of(along);
}

double LevelCurve::length_between(std::uint32_t site, double a, double b) const noexcept {
  return (is_wall(site) ? 1 : distance_) * std::abs(b - a);
}

void LevelCurve::append_points(std::uint32_t site, double a, double b,
                               std::vector<Vec2>& points) const {
  if (!is_wall(site)) {
    const ReflexCorner& corner = map_->corner(site);
    return append_arc(corner.position, corner.begin, distance_, a, b, points);
  }
  append_point(point_at(site, a), points);
  append_point(point_at(site, b), points);
}

double LevelCurve::area_between(std::uint32_t site, double a, double b,
                                Vec2 origin) const noexcept {
  const Vec2 p = point_at(site, a) - origin, q = point_at(site, b) - origin;
  if (is_wall(site)) return cross(p, q) / 2;
  // Under the chord, and between it and the arc: small pieces of large circles lose nothing.
  return (cross(p, q) + distance_ * distance_ * (b - a - std::sin(b - a))) / 2;
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

/// Follows the curve from one crossing until it closes; gives its pieces.
std::vector<LevelPiece> follow(const LevelCurve& curve, LevelCrossing first,
                               StampedArray<char>& followed) {
  std::vector<LevelPiece> pieces;
  for (LevelCrossing at = first; !followed.has(at); at = pieces.back().to) {
    followed[at] = 1;
    pieces.push_back(curve.piece_from(at));
  }
  return pieces;
}

/// Gives pieces that begin in one pinch of the floor the same number, all others their own. That
/// pieces begin near each other does not say that the curve touches itself: beside a vertex that
/// hardly juts out of a wall, or a wall that is about to vanish, a piece is as short as it likes.
std::vector<std::uint32_t> number_places(const LevelCurve& curve,
                                         const std::vector<LevelPiece>& pieces) {
  constexpr double same_place = 1e-6;  // metres; the vertices of one pinch may be several
  std::vector<std::uint32_t> number(pieces.size()), order;
  std::iota(number.begin(), number.end(), 0U);
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    if (curve.crossings_of(pieces[i].from / 2).at_pinch) order.push_back(i);
  const auto point = [&](std::uint32_t i) { return pieces[i].first; };
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair(point(i).x, i); });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i; j-- > 0;) {
      const Vec2 apart = point(order[i]) - point(order[j]);
      if (apart.x > same_place) break;
      if (std::abs(apart.y) <= same_place) number[order[i]] = number[order[j]];
    }
  return number;
}

/// Splits a closed row of pieces where it touches itself, which is where the floor is pinched to
/// the distance, so that no ring passes such a point twice: two holes that touch stay two.
std::vector<std::vector<LevelPiece>> split_where_touching(const LevelCurve& curve,
                                                          const std::vector<LevelPiece>& pieces) {
  const auto place = number_places(curve, pieces);
  std::vector<std::vector<LevelPiece>> rings;
  std::vector<std::size_t> open;                    // pieces not yet in a ring, in order
  std::vector<bool> visited(pieces.size(), false);  // per place: does an open piece begin there?
  for (std::size_t i = 0; i <= pieces.size(); ++i) {
    const std::uint32_t here = place[i % pieces.size()];
    if (visited[here]) {
      std::vector<LevelPiece> ring;
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

OffsetRing make_ring(const LevelCurve& curve, const std::vector<LevelPiece>& pieces) {
  OffsetRing ring;
  const Vec2 origin = pieces.front().first;
  for (const LevelPiece& piece : pieces) {
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
    thread_local StampedArray<char> followed;  // kept, so that no curve has to clear them
    followed.forget(2 * map.diagram().edge.size());
    map.visit_edges_across(distance + touching, [&](std::uint32_t e) {
      for (LevelCrossing at = 2 * e; at < 2 * e + curve.crossings_of(e).count; ++at)
        if (!followed.has(at))
          for (const auto& pieces : split_where_touching(curve, follow(curve, at, followed)))
            made.rings.push_back(make_ring(curve, pieces));
    });
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

}  // namespace docent::path
