#include "runtime/model/geometry/door_leaf.h"

#include <algorithm>
#include <vector>

#include "runtime/model/none.h"

namespace docent {
namespace {

/// How far it is from a point to the first wall in a direction (of length 1); infinity for none.
double distance_to_wall(const FloorPlan& plan, Vec2 from, Vec2 direction) noexcept {
  double nearest = infinity;
  for (std::uint32_t wall = 0; wall < plan.vertex.size(); ++wall) {
    const Vec2 a = wall_start(plan, wall) - from,
               run = wall_end(plan, wall) - wall_start(plan, wall);
    const double across = cross(direction, run);
    if (across == 0) continue;
    const double along = cross(a, run) / across, share = cross(a, direction) / across;
    if (along >= 0 && share >= 0 && share <= 1) nearest = std::min(nearest, along);
  }
  return nearest;
}

DoorLeaf::End leaf_end(const FloorPlan& plan, Vec2 end, Vec2 outwards) noexcept {
  if (!is_walkable(plan, end)) return {end, 0};
  const double gap = distance_to_wall(plan, end, outwards);
  if (gap <= largest_door_gap) return {end + gap * outwards, 0};
  return {end, gap};
}

}  // namespace

bool is_walkable(const FloorPlan& plan, Vec2 point) noexcept {
  bool inside = false;
  for (std::uint32_t wall = 0; wall < plan.vertex.size(); ++wall) {
    const Vec2 a = wall_start(plan, wall), b = wall_end(plan, wall);
    if ((a.y > point.y) != (b.y > point.y) &&
        point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x))
      inside = !inside;
  }
  return inside;
}

bool crosses_floor(const FloorPlan& plan, const Door& door) {
  if (door.a == door.b) return false;
  const Vec2 along = door.b - door.a;
  std::vector<double> walls{0, 1};  // where they cross it, as shares of the door
  for (std::uint32_t wall = 0; wall < plan.vertex.size(); ++wall) {
    const Vec2 a = wall_start(plan, wall) - door.a, run = wall_end(plan, wall) - a - door.a;
    const double across = cross(along, run);
    if (across == 0) continue;
    const double share = cross(a, run) / across, of_wall = cross(a, along) / across;
    if (share > 0 && share < 1 && of_wall >= 0 && of_wall <= 1) walls.push_back(share);
  }
  std::ranges::sort(walls);
  for (std::size_t i = 0; i + 1 < walls.size(); ++i)
    if (is_walkable(plan, door.a + (walls[i] + walls[i + 1]) / 2 * along)) return true;
  return false;
}

DoorLeaf door_leaf(const FloorPlan& plan, const Door& door) noexcept {
  const Vec2 along = glm::normalize(door.b - door.a);
  return {leaf_end(plan, door.a, -along), leaf_end(plan, door.b, along)};
}

}  // namespace docent
