#include "content/floor/close_doors.h"

#include <algorithm>
#include <utility>

#include "content/floor/mend.h"
#include "content/floor/ring_overlay.h"
#include "runtime/model/geometry/door_leaf.h"

namespace docent::floor {
namespace {

/// How far a closed door reaches into its walls, so that rounding leaves no slit. Metres.
constexpr double hold = 0.005;

/// The end of a closed door, within the wall that it meets.
Vec2 end_in_wall(const DoorLeaf::End& end, Vec2 outwards) noexcept {
  return end.gap > 0 ? end.at : end.at + hold * outwards;
}

/// A door's four corners, clockwise: the floor lies on the left of a wall, and this is none.
std::vector<Vec2> leaf(Vec2 a, Vec2 b) {
  const Vec2 along = glm::normalize(b - a), half = 0.5 * door_thickness * Vec2{-along.y, along.x};
  return {a - half, a + half, b + half, b - half};
}

class DoorCloser {
 public:
  DoorCloser(const FloorPlan& plan, std::vector<DoorFault>& faults) : plan_(plan), faults_(faults) {
    for (const Ring& ring : plan.ring)
      rings_.push_back({.vertex = {plan.vertex.begin() + ring.first,
                                   plan.vertex.begin() + ring.first + ring.count}});
  }

  void close(const Door& door, std::uint32_t index) {
    if (door.a == door.b || !is_walkable(plan_, 0.5 * (door.a + door.b)))
      return faults_.push_back({.door = index, .kind = DoorFault::Kind::Outside});
    const Vec2 along = glm::normalize(door.b - door.a);
    const DoorLeaf closed = door_leaf(plan_, door);
    for (const auto& [end, drawn] : {std::pair{closed.a, door.a}, std::pair{closed.b, door.b}})
      if (end.gap > 0)
        faults_.push_back(
            {.door = index, .kind = DoorFault::Kind::LeavesGap, .gap = end.gap, .end = drawn});
    rings_.push_back({.vertex = leaf(end_in_wall(closed.a, -along), end_in_wall(closed.b, along))});
  }

  FloorPlan plan() && {
    FloorPlan closed = plan_of_walls(std::move(rings_));
    closed.name = plan_.name;
    return closed;
  }

 private:
  const FloorPlan& plan_;
  std::vector<DoorFault>& faults_;
  std::vector<OverlayRing> rings_;
};

}  // namespace

FloorPlan close_doors(const FloorPlan& plan, std::span<const Door> doors,
                      std::vector<DoorFault>& faults) {
  if (std::ranges::none_of(doors, &Door::closed)) return plan;
  DoorCloser closer(plan, faults);
  for (std::uint32_t i = 0; i < doors.size(); ++i)
    if (doors[i].closed) closer.close(doors[i], i);
  return std::move(closer).plan();
}

}  // namespace docent::floor
