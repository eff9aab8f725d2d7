#include "content/floor/bend.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace docent::floor {
namespace {

constexpr double pi = std::numbers::pi;
/// What rounding and the tolerances of touching are given: metres, and radians.
constexpr double slack = 1e-6;

/// Angles from `low` counter-clockwise to `high`. Radians.
struct Sector {
  double low, high;
};

/// What two sectors share that are less than a full turn together; in the turn of the first.
std::optional<Sector> shared(Sector a, Sector b) {
  const double between_middles = (b.low + b.high - a.low - a.high) / 2;
  const double turn = 2 * pi * std::round(between_middles / (2 * pi));
  const Sector both{std::max(a.low, b.low - turn), std::min(a.high, b.high - turn)};
  if (both.low > both.high) return {};
  return both;
}

double angle_from(Vec2 zero, Vec2 direction) {
  return std::atan2(cross(zero, direction), dot(zero, direction));
}

/// The directions of a bend, from a direction that counts as zero.
Sector directions(const Bend& bend, Vec2 zero) {
  const double begin = angle_from(zero, bend.begin);
  return {begin - slack, begin + std::max(0.0, angle_from(bend.begin, bend.end)) + slack};
}

bool lies_in(const Bend& bend, Vec2 direction) {
  return cross(bend.begin, direction) >= -slack && cross(direction, bend.end) >= -slack;
}

/// Do all directions of the bend point further along the unit vector `ahead` than the sine says?
/// Quick, for most corners of a wall that is not quite smooth.
bool all_point_ahead(const Bend& bend, Vec2 ahead, double sine) {
  return std::min(dot(bend.begin, ahead), dot(bend.end, ahead)) > sine + slack &&
         !lies_in(bend, -ahead);
}

}  // namespace

std::vector<Bend> bends_at(const FloorPlan& plan, const VoronoiDiagram& diagram,
                           std::span<const std::uint32_t> corners) {
  std::vector<double> reach(plan.vertex.size(), 0);
  const auto extend = [&](std::uint32_t site, const VoronoiEdge& edge) {
    if (diagram.site[site].kind != Site::Kind::Corner) return;
    double& known = reach[diagram.site[site].index];
    known = std::max({known, diagram.clearance[edge.from], diagram.clearance[edge.to]});
  };
  for (const VoronoiEdge& edge : diagram.edge) {
    extend(edge.left, edge);
    extend(edge.right, edge);
  }
  std::vector<std::uint32_t> previous(plan.vertex.size());
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) previous[plan.next[i]] = i;
  std::vector<Bend> bends;
  bends.reserve(corners.size());
  for (const std::uint32_t corner : corners) {
    const Vec2 here = plan.vertex[corner];
    bends.push_back({here, left_of(glm::normalize(plan.vertex[plan.next[corner]] - here)),
                     left_of(glm::normalize(here - plan.vertex[previous[corner]])), reach[corner]});
  }
  return bends;
}

bool some_disc_goes_straight(const Bend& a, const Bend& b) {
  const Vec2 between = b.position - a.position;
  const double distance = glm::length(between);
  if (!(distance > 0)) return true;
  const Vec2 ahead = between / distance;
  // A disc of radius r passes both corners on one side in the directions at right angles to the
  // line between them, and on either side in those that turn from there towards the other corner by
  // the arc sine of 2 r / distance.
  const double sine = std::min(1.0, 2 * (std::min(a.reach, b.reach) + slack) / distance);
  if (all_point_ahead(a, ahead, sine) || all_point_ahead(b, -ahead, sine)) return false;
  const Sector of_a = directions(a, ahead), of_b = directions(b, ahead);
  for (const double side : {-pi / 2, pi / 2}) {
    const auto at_a = shared({side, side}, of_a);
    if (at_a && shared({side, side}, of_b)) return true;
    // Across, the direction at `b` is opposite to that at `a`.
    const double turn = std::asin(sine) + slack;
    const Sector turned = side < 0 ? Sector{side, side + turn} : Sector{side - turn, side};
    const auto across = shared(turned, of_a);
    if (across && shared(*across, {of_b.low - pi, of_b.high - pi})) return true;
  }
  return false;
}

unsigned straight_ways_of_a_point(const Bend& a, const Bend& b) {
  const Vec2 left = left_of(b.position - a.position);
  const Vec2 unit = left / std::max(glm::length(left), 1e-300);
  const auto sides = [&](const Bend& bend) {
    return static_cast<unsigned>(lies_in(bend, unit)) + static_cast<unsigned>(lies_in(bend, -unit));
  };
  return sides(a) * sides(b);
}

}  // namespace docent::floor
