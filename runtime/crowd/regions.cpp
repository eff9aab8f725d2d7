#include "runtime/crowd/regions.h"

#include <algorithm>
#include <cmath>

#include "runtime/model/geometry/orientation.h"
#include "runtime/path/floor_map.h"

namespace docent::crowd {
namespace {

/// So many steps in a row are no walk any more.
constexpr int most_steps = 64;
/// Nearer to a wall than this, exact predicates say which side one is on. Metres.
constexpr double at_wall = 1e-9;
/// Rounding of a distance, and much more. Metres.
constexpr double rounding = 1e-9;

}  // namespace

Regions::Foot Regions::foot_on(const SiteShape& shape, Vec2 point) noexcept {
  const Vec2 from_a = point - shape.a;
  if (!shape.is_wall) return {dot(from_a, from_a), 0};
  const double at = dot(from_a, shape.along);
  if (at <= 0) return {dot(from_a, from_a), at};
  const Vec2 from_b = point - shape.b;
  if (at >= shape.length) return {dot(from_b, from_b), at};
  const double beside = cross(shape.along, from_a);
  return {beside * beside, at};
}

Regions::Regions(const path::FloorMap& map) : map_(map) {
  const FloorPlan& plan = map.plan();
  const VoronoiDiagram& diagram = map.floor().diagram;
  const auto regions = static_cast<std::uint32_t>(diagram.site.size());
  std::vector<std::uint32_t> corner_site(plan.vertex.size(), none),
      ends_here(plan.vertex.size(), 0);
  for (std::uint32_t wall = 0; wall < plan.next.size(); ++wall) ends_here[plan.next[wall]] = wall;
  for (std::uint32_t s = 0; s < regions; ++s)
    if (diagram.site[s].kind == Site::Kind::Corner) corner_site[diagram.site[s].index] = s;

  shape_.resize(regions);
  next_first_.assign(1, 0);
  for (std::uint32_t s = 0; s < regions; ++s) {
    const auto [kind, index] = diagram.site[s];
    SiteShape& shape = shape_[s];
    shape.a = shape.b = plan.vertex[index];
    if (kind == Site::Kind::Wall) {
      shape.is_wall = true;
      shape.b = wall_end(plan, index);
      shape.length = glm::distance(shape.a, shape.b);
      shape.along = (shape.b - shape.a) / shape.length;
      shape.at_a = corner_site[index];
      shape.at_b = corner_site[plan.next[index]];
    } else {
      shape.at_a = map.site_of_wall(ends_here[index]);
      shape.at_b = map.site_of_wall(index);
    }
    std::vector<std::uint32_t> next;
    for (std::uint32_t i = diagram.region_first[s]; i < diagram.region_first[s + 1]; ++i) {
      const VoronoiEdge& edge = diagram.edge[diagram.region_edge[i]];
      next.push_back(edge.left == s ? edge.right : edge.left);
    }
    std::ranges::sort(next);
    next.erase(std::ranges::unique(next).begin(), next.end());
    next_.insert(next_.end(), next.begin(), next.end());
    next_first_.push_back(static_cast<std::uint32_t>(next_.size()));
  }
}

/// The place of a point that is in this region, as far as this region and its neighbours know: or
/// the neighbour that is nearest to it, in `nearer`.
Regions::Place Regions::place_in(Vec2 point, std::uint32_t region, Foot foot,
                                 Nearer& nearer) const noexcept {
  const SiteShape& own = shape_[region];
  double slack = std::numeric_limits<double>::infinity();
  double nearest_squared = slack;
  nearer = {none, foot};
  for (const std::uint32_t next : next_to(region)) {
    const SiteShape& other = shape_[next];
    const Foot to_other = foot_on(other, point);
    if (to_other.distance_squared < nearer.foot.distance_squared) nearer = {next, to_other};
    // The border between a wall and its own corner stands upright on the wall.
    if (own.is_wall && next == own.at_a)
      slack = std::min(slack, foot.at);
    else if (own.is_wall && next == own.at_b)
      slack = std::min(slack, own.length - foot.at);
    else if (!own.is_wall && next == own.at_a)
      slack = std::min(slack, dot(point - own.a, other.along));
    else if (!own.is_wall && next == own.at_b)
      slack = std::min(slack, -dot(point - own.a, other.along));
    else
      nearest_squared = std::min(nearest_squared, to_other.distance_squared);
  }
  const double distance = std::sqrt(foot.distance_squared);
  slack = std::min({slack, distance, (std::sqrt(nearest_squared) - distance) / 2}) - rounding;
  return {region, std::max(distance - rounding, 0.0), std::max(slack, 0.0)};
}

Regions::Place Regions::find(Vec2 point) const noexcept {
  if (shape_.empty() || !map_.is_inside(point)) return {};
  const std::uint32_t region = map_.site_at(point);
  Nearer nearer;
  return place_in(point, region, foot_on(shape_[region], point), nearer);
}

Regions::Place Regions::follow(Vec2 point, std::uint32_t region) const noexcept {
  if (region >= shape_.size()) return find(point);
  Foot foot = foot_on(shape_[region], point);
  for (int step = 0; step < most_steps; ++step) {
    // Beyond its end a wall is as near as its corner is; that is the corner's region. The distance
    // stays the same bit for bit, and grows less in every other step, so the walk ends.
    if (const SiteShape& own = shape_[region]; own.is_wall) {
      if (foot.at <= 0 && own.at_a != none)
        region = own.at_a;
      else if (foot.at >= own.length && own.at_b != none)
        region = own.at_b;
    }
    Nearer nearer;
    const Place place = place_in(point, region, foot, nearer);
    if (nearer.region != none) {
      region = nearer.region;
      foot = nearer.foot;
      continue;
    }
    // The line from the nearest point of a site to `point` leaves the site's region, if at all, for
    // a neighbour that is nearer. None is, so the point is here, if it is on the open side.
    const SiteShape& own = shape_[region];
    const bool is_clear_of_walls = foot.distance_squared > at_wall * at_wall;
    const bool is_before_wall = !own.is_wall || (foot.at > 0 && foot.at < own.length &&
                                                 orientation(own.a, own.b, point) > 0);
    if (!is_clear_of_walls || !is_before_wall) break;
    return place;
  }
  return find(point);
}

}  // namespace docent::crowd
