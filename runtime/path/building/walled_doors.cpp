#include "runtime/path/building/walled_doors.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace docent::path {
namespace {

/// A place beside a door, from which one would go through it.
struct Side {
  DoorOfFloor door;
  Vec2 place{};
};

/// Of an even side the next one is the other.
constexpr std::size_t other(std::size_t side) noexcept {
  return side ^ 1U;
}

std::optional<Vec2> place_beside(const FloorMap& map, const Door& door, double radius,
                                 double sign) {
  constexpr double step = 0.05, farthest = 1.5;  // metres
  const Vec2 middle = 0.5 * (door.a + door.b);
  const Vec2 across = sign * left_of(glm::normalize(door.b - door.a));
  for (double away = step; away <= farthest; away += step)
    if (const Vec2 place = middle + away * across; map.has_room(place, radius)) return place;
  return {};
}

/// The sides of all doors that a disc fits through.
std::vector<Side> sides_of(const Museum& museum, const BuildingMap& building, double radius) {
  constexpr std::size_t most_doors = 24;
  std::vector<Side> sides;
  for (std::uint32_t floor = 0; floor < museum.floors.size(); ++floor) {
    const std::vector<Door>& doors = museum.floors[floor].plan.doors;
    for (std::uint32_t i = 0; i < doors.size() && sides.size() < 2 * most_doors; ++i) {
      if (!doors[i].closed || glm::distance(doors[i].a, doors[i].b) < 2 * radius) continue;
      const auto left = place_beside(building.floor(floor), doors[i], radius, 1);
      const auto right = place_beside(building.floor(floor), doors[i], radius, -1);
      if (!left || !right) continue;
      sides.push_back({{floor, i}, *left});
      sides.push_back({{floor, i}, *right});
    }
  }
  return sides;
}

/// Goes through doors in the order of their number from the start.
class DoorSearch {
 public:
  DoorSearch(const BuildingMap& building, const BuildingQuery& query, std::vector<Side> sides)
      : building_(building),
        query_(query),
        sides_(std::move(sides)),
        came_by_(sides_.size(), unseen) {
    query_.permissions.closed_too = true;
    query_.way.tell_clearance = false;
  }

  std::vector<DoorOfFloor> run() {
    std::vector<std::size_t> waiting{start};
    for (std::size_t next = 0; next < waiting.size(); ++next) {
      const std::size_t at = waiting[next];
      if (leads(at, query_.way.to, query_.to_floor)) return doors_to(at);
      for (std::size_t side = 0; side < sides_.size(); ++side) {
        if (came_by_[other(side)] != unseen) continue;
        if (!leads(at, sides_[side].place, sides_[side].door.floor)) continue;
        came_by_[other(side)] = at;
        waiting.push_back(other(side));
      }
    }
    return {};
  }

 private:
  static constexpr std::size_t start = static_cast<std::size_t>(-1), unseen = start - 1;

  bool leads(std::size_t from, Vec2 to, std::uint32_t floor) const {
    BuildingQuery asked = query_;
    if (from != start) {
      asked.way.from = sides_[from].place;
      asked.from_floor = sides_[from].door.floor;
    }
    asked.way.to = to;
    asked.to_floor = floor;
    return building_.route(asked).status == BuildingStatus::Ok;
  }
  std::vector<DoorOfFloor> doors_to(std::size_t side) const {
    std::vector<DoorOfFloor> doors;
    for (; side != start; side = came_by_[side]) doors.push_back(sides_[side].door);
    std::ranges::reverse(doors);
    return doors;
  }

  const BuildingMap& building_;
  BuildingQuery query_;
  std::vector<Side> sides_;
  std::vector<std::size_t> came_by_;  ///< By the side on which one comes out.
};

}  // namespace

std::vector<DoorOfFloor> walled_doors_in_the_way(const Museum& museum, const BuildingMap& building,
                                                 const BuildingQuery& query) {
  std::vector<Side> sides = sides_of(museum, building, query.way.radius);
  if (sides.empty()) return {};
  return DoorSearch(building, query, std::move(sides)).run();
}

}  // namespace docent::path
