#include "runtime/path/floor_map.h"

#include <algorithm>
#include <cmath>

#include "runtime/path/shortest/make_tangent_graph.h"

namespace docent::path {

FloorMap::FloorMap(const Floor& floor)
    : floor_(floor),
      walls_(floor.plan, 0),
      search_(floor.plan, floor.sight, walls_),
      axis_(floor),
      shortest_ways_(floor, search_) {
  wall_site_.assign(floor.plan.vertex.size(), 0);
  const auto& sites = floor.diagram.site;
  for (std::uint32_t s = 0; s < sites.size(); ++s)
    if (sites[s].kind == Site::Kind::Wall) wall_site_[sites[s].index] = s;
  corner_site_ = wall_site_;
  for (std::uint32_t s = 0; s < sites.size(); ++s)
    if (sites[s].kind == Site::Kind::Corner) corner_site_[sites[s].index] = s;
}

std::uint32_t FloorMap::site_at(Vec2 point) const noexcept {
  const auto nearest = walls_.nearest_wall(point);
  if (!std::isfinite(nearest.distance)) return 0;
  if (nearest.t == 0) return corner_site_[nearest.wall];
  if (nearest.t == 1) return corner_site_[floor_.plan.next[nearest.wall]];
  return wall_site_[nearest.wall];
}

Fit FloorMap::fit_at(Vec2 point, double radius) const noexcept {
  const auto nearest = walls_.nearest_wall(point);
  if (!std::isfinite(nearest.distance)) return Fit::None;
  const bool is_inside = walls_.is_inside(point, nearest);
  if (radius < smallest_radius)
    return is_inside ? Fit::Inside : nearest.distance <= touching ? Fit::Behind : Fit::None;
  return is_inside && nearest.distance >= least_clearance(radius) ? Fit::Inside : Fit::None;
}

}  // namespace docent::path
