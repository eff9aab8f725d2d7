#include "runtime/path/floor_map.h"

#include <algorithm>
#include <cmath>

#include "runtime/path/make_tangent_graph.h"
#include "runtime/path/predicates.h"

namespace docent {

FloorMap::OwnedMap::OwnedMap(const FloorPlan& plan, double radius)
    : graph(make_tangent_graph(plan, radius)), map(plan, graph) {}

FloorMap::FloorMap(const Floor& floor)
    : floor_(floor), walls_(floor.plan, 0), axis_(floor), previous_(floor.plan.vertex.size()) {
  const FloorPlan& plan = floor.plan;
  for (std::uint32_t i = 0; i < plan.vertex.size(); ++i) previous_[plan.next[i]] = i;
  wall_site_.assign(plan.vertex.size(), 0);
  const auto& sites = floor.diagram.site;
  for (std::uint32_t s = 0; s < sites.size(); ++s)
    if (sites[s].kind == Site::Kind::Wall) wall_site_[sites[s].index] = s;
  corner_site_ = wall_site_;
  for (std::uint32_t s = 0; s < sites.size(); ++s)
    if (sites[s].kind == Site::Kind::Corner) corner_site_[sites[s].index] = s;
  for (const TangentGraph& graph : floor.tangent_graphs)
    precomputed_.push_back(std::make_shared<const ShortestWayMap>(plan, graph));
}

bool FloorMap::is_inside(Vec2 point) const noexcept {
  const auto nearest = walls_.nearest_wall(point);
  if (!std::isfinite(nearest.distance)) return false;
  const FloorPlan& plan = floor_.plan;
  if (nearest.distance == 0) return true;
  if (nearest.t > 0 && nearest.t < 1)
    return orientation(wall_start(plan, nearest.wall), wall_end(plan, nearest.wall), point) >= 0;
  // Nearest to a corner: a reflex one is seen from inside, a convex one from outside.
  const std::uint32_t corner = nearest.t > 0 ? plan.next[nearest.wall] : nearest.wall;
  return orientation(plan.vertex[previous_[corner]], plan.vertex[corner],
                     plan.vertex[plan.next[corner]]) <= 0;
}

std::uint32_t FloorMap::site_at(Vec2 point) const noexcept {
  const auto nearest = walls_.nearest_wall(point);
  if (!std::isfinite(nearest.distance)) return 0;
  if (nearest.t == 0) return corner_site_[nearest.wall];
  if (nearest.t == 1) return corner_site_[floor_.plan.next[nearest.wall]];
  return wall_site_[nearest.wall];
}

bool FloorMap::has_room(Vec2 point, double radius) const noexcept {
  const double clearance = clearance_at(point);
  if (!std::isfinite(clearance)) return false;
  if (radius < smallest_radius) return clearance <= touching || is_inside(point);
  return clearance >= radius - touching && is_inside(point);
}

std::shared_ptr<const ShortestWayMap> FloorMap::shortest_ways(double radius) const {
  if (radius < smallest_radius) radius = 0;
  const auto has_radius = [&](const auto& map) { return map->graph.radius == radius; };
  if (const auto found = std::ranges::find_if(precomputed_, has_radius);
      found != precomputed_.end())
    return *found;
  const std::scoped_lock lock(mutex_);
  if (const auto found = std::ranges::find_if(made_, has_radius); found != made_.end())
    return *found;
  const auto owned = std::make_shared<const OwnedMap>(floor_.plan, radius);
  if (made_.size() == kept_radii) made_.erase(made_.begin());
  return made_.emplace_back(owned, &owned->map);
}

}  // namespace docent
