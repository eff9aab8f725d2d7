#include "content/floor/tritangent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace docent::floor {
namespace {

using Real = long double;

struct Point {
  Real x = 0, y = 0;
};
Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
Point operator*(Real s, Point a) {
  return {s * a.x, s * a.y};
}
Real dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}
Real cross(Point a, Point b) {
  return a.x * b.y - a.y * b.x;
}
Point unit(Point a) {
  return (1 / std::hypot(a.x, a.y)) * a;
}
Point left_of(Point a) {
  return {-a.y, a.x};
}

/// A site about the local origin.
struct LocalSite {
  bool is_wall = false;
  Point a, b;
  Point tangent{}, normal{};  // Of a wall.
};

/// A centre with its radius: a point of the space in which walls are planes.
struct Disc {
  Real x = 0, y = 0, r = 0;
};
Disc operator+(Disc a, Disc b) {
  return {a.x + b.x, a.y + b.y, a.r + b.r};
}
Disc operator*(Real s, Disc a) {
  return {s * a.x, s * a.y, s * a.r};
}
Disc cross(Disc a, Disc b) {
  return {a.y * b.r - a.r * b.y, a.r * b.x - a.x * b.r, a.x * b.y - a.y * b.x};
}
Real dot(Disc a, Disc b) {
  return a.x * b.x + a.y * b.y + a.r * b.r;
}

/// All discs d with dot(normal, d) = offset.
struct Plane {
  Disc normal;
  Real offset = 0;
};

bool same(Point a, Point b) {
  return a.x == b.x && a.y == b.y;
}

bool ends_at(const LocalSite& wall, Point corner) {
  return same(wall.a, corner) || same(wall.b, corner);
}

/// Discs that touch a wall from its left.
Plane touching(const LocalSite& wall) {
  return {{wall.normal.x, wall.normal.y, -1}, dot(wall.normal, wall.a)};
}
/// Discs with their centre on a line.
Plane centred_on(Point point, Point direction) {
  const Point n = left_of(direction);
  return {{n.x, n.y, 0}, dot(n, point)};
}
/// Discs with their centre on the line between two corners.
Plane between(Point a, Point b) {
  return centred_on(Real(0.5) * (a + b), left_of(unit(b - a)));
}

/// Where two walls that share a corner have their bisector.
std::optional<Plane> shared_corner(const LocalSite& v, const LocalSite& w) {
  const bool v_first = same(v.b, w.a), w_first = same(w.b, v.a);
  if (!v_first && !w_first) return std::nullopt;
  const LocalSite &before = v_first ? v : w, &after = v_first ? w : v;
  // The normals' sum and the tangents' difference both point along it, against each other where the
  // corner turns right; the one vanishes where it is sharp, the other where it is flat.
  const Point across = before.normal + after.normal, turn = after.tangent - before.tangent;
  const Point along = cross(before.tangent, after.tangent) < 0 ? across - turn : across + turn;
  return centred_on(after.a, unit(along));
}

/// Solves three planes; the rows are of unit size, so plain Cramer is as good as pivoting.
Disc intersect(const Plane& a, const Plane& b, const Plane& c) {
  const Disc bc = cross(b.normal, c.normal);
  return (1 / dot(a.normal, bc)) * (a.offset * bc + b.offset * cross(c.normal, a.normal) +
                                    c.offset * cross(a.normal, b.normal));
}

struct Line {
  Disc base, direction;
};

Line intersect(const Plane& a, const Plane& b) {
  const Disc along = cross(a.normal, b.normal);
  const Plane nearest{along, 0};  // The point of the line nearest to the local origin.
  return {intersect(a, b, nearest), (1 / std::sqrt(dot(along, along))) * along};
}

/// No disc is farther than this from its sites, in metres; a root that is comes from an equation of
/// the first degree whose rounding errors look like a second.
constexpr Real farthest = 1e7L;

/// Real roots of a s^2 + 2 b s + c, without cancellation; a nearly touching pair counts as
/// touching.
std::vector<Real> roots(Real a, Real b, Real c) {
  const Real q = -(b + std::copysign(std::sqrt(std::max(b * b - a * c, Real(0))), b));
  std::vector<Real> result;
  if (std::abs(q) < std::abs(a) * farthest) result.push_back(q / a);
  if (q != 0) result.push_back(c / q);
  if (result.empty()) result.push_back(0);
  return result;
}

/// The discs of a line that touch a corner: |(x, y) - corner| = |r|.
std::vector<Disc> touching(const Line& line, Point corner) {
  const Point from = Point{line.base.x, line.base.y} - corner;
  const Point along{line.direction.x, line.direction.y};
  const Real slope = line.direction.r;
  std::vector<Disc> discs;
  for (const Real s :
       roots(dot(along, along) - slope * slope, dot(along, from) - slope * line.base.r,
             dot(from, from) - line.base.r * line.base.r))
    discs.push_back(line.base + s * line.direction);
  return discs;
}

Point contact(const LocalSite& site, const Disc& disc) {
  return site.is_wall ? Point{disc.x, disc.y} - disc.r * site.normal : site.a;
}

/// How far a disc is from touching the sites in order and within the walls: zero for the right one.
Real misfit(const std::array<LocalSite, 3>& sites, const Disc& disc) {
  std::array<Point, 3> touch;
  Real beyond_ends = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    touch[i] = contact(sites[i], disc);
    if (!sites[i].is_wall) continue;
    const Real at = dot(touch[i] - sites[i].a, sites[i].tangent);
    const Real length = dot(sites[i].b - sites[i].a, sites[i].tangent);
    beyond_ends += std::max({-at, at - length, Real(0)});
  }
  const Real area = cross(touch[1] - touch[0], touch[2] - touch[0]);
  const Real size =
      std::max({dot(touch[1] - touch[0], touch[1] - touch[0]),
                dot(touch[2] - touch[0], touch[2] - touch[0]), std::numeric_limits<Real>::min()});
  return beyond_ends + std::abs(disc.r) * std::max(-area / size, Real(0));
}

Disc best(const std::array<LocalSite, 3>& sites, const std::vector<Disc>& discs) {
  return *std::ranges::min_element(discs, {}, [&](const Disc& d) { return misfit(sites, d); });
}

/// Three corners: the circle through them.
Disc circumscribed(Point a, Point b, Point c) {
  const Plane flat{{0, 0, 1}, 0};
  Disc disc = intersect(between(a, b), between(a, c), flat);
  disc.r = std::hypot(disc.x - a.x, disc.y - a.y);
  return disc;
}

Disc solve_corners_and_wall(const std::array<LocalSite, 3>& sites, Point p, Point q,
                            const LocalSite& wall) {
  for (const auto& [own, other] : {std::pair(p, q), std::pair(q, p)})
    if (ends_at(wall, own))
      return intersect(centred_on(own, wall.normal), touching(wall), between(own, other));
  return best(sites, touching(intersect(between(p, q), touching(wall)), p));
}

Disc solve_corner_and_walls(const std::array<LocalSite, 3>& sites, Point p, const LocalSite& v,
                            const LocalSite& w) {
  if (ends_at(v, p) && ends_at(w, p)) return {p.x, p.y, 0};
  if (ends_at(v, p)) return intersect(centred_on(p, v.normal), touching(v), touching(w));
  if (ends_at(w, p)) return intersect(centred_on(p, w.normal), touching(w), touching(v));
  const Plane bisector = shared_corner(v, w).value_or(touching(w));
  return best(sites, touching(intersect(touching(v), bisector), p));
}

Disc solve_walls(const LocalSite& u, const LocalSite& v, const LocalSite& w) {
  const auto uv = shared_corner(u, v), vw = shared_corner(v, w), wu = shared_corner(w, u);
  if (uv && vw) return intersect(touching(v), *uv, *vw);
  if (vw && wu) return intersect(touching(w), *vw, *wu);
  if (wu && uv) return intersect(touching(u), *wu, *uv);
  if (uv) return intersect(touching(u), *uv, touching(w));
  if (vw) return intersect(touching(v), *vw, touching(u));
  if (wu) return intersect(touching(w), *wu, touching(v));
  return intersect(touching(u), touching(v), touching(w));
}

Disc solve(const std::array<LocalSite, 3>& sites) {
  std::vector<LocalSite> walls;
  std::vector<Point> corners;
  for (const LocalSite& site : sites) {
    if (site.is_wall)
      walls.push_back(site);
    else
      corners.push_back(site.a);
  }
  switch (walls.size()) {
    case 0:
      return circumscribed(corners[0], corners[1], corners[2]);
    case 1:
      return solve_corners_and_wall(sites, corners[0], corners[1], walls[0]);
    case 2:
      return solve_corner_and_walls(sites, corners[0], walls[0], walls[1]);
    default:
      return solve_walls(walls[0], walls[1], walls[2]);
  }
}

}  // namespace

TritangentDisc tritangent_disc(const std::array<TangentSite, 3>& sites) {
  const Point origin{sites[0].a.x, sites[0].a.y};
  const auto local = [origin](Vec2 p) { return Point{p.x, p.y} - origin; };
  std::array<LocalSite, 3> local_sites;
  for (std::size_t i = 0; i < 3; ++i) {
    LocalSite& site = local_sites[i];
    site = {.is_wall = sites[i].is_wall, .a = local(sites[i].a), .b = local(sites[i].b)};
    if (!site.is_wall) continue;
    site.tangent = unit(site.b - site.a);
    site.normal = left_of(site.tangent);
  }
  const Disc disc = solve(local_sites);
  return {{static_cast<double>(origin.x + disc.x), static_cast<double>(origin.y + disc.y)},
          static_cast<double>(disc.r)};
}

}  // namespace docent::floor
