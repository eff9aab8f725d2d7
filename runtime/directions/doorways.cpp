#include "runtime/directions/doorways.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/model/exhibit/room_of.h"
#include "runtime/model/geometry/polygon.h"

namespace docent::directions {
namespace {

constexpr double step = 0.1;       // metres along an outline from one trial to the next
constexpr double reach = 0.6;      // metres to either side of it that one steps
constexpr double column = 0.6;     // metres: what is as thin as that does not make two doors of one
constexpr double narrowest = 0.5;  // metres
constexpr double look_beyond = 2.5;  // metres

bool is_open(const path::FloorMap& map, Vec2 at, Vec2 outward) {
  const Vec2 inside = at - reach * outward, outside = at + reach * outward;
  return path::is_inside(map, inside) && path::is_inside(map, outside) &&
         path::can_see(map, inside, outside);
}

/// Which room one comes to through a doorway.
std::uint32_t beyond(const Museum& museum, const path::FloorMap& map, std::uint32_t room,
                     const Doorway& doorway) {
  for (double ahead = step; ahead <= look_beyond; ahead += step) {
    const Vec2 at = doorway.middle + ahead * doorway.outward;
    if (!path::can_see(map, doorway.middle, at)) break;
    const std::uint32_t there = room_of(museum, museum.rooms[room].floor, at);
    if (there != none && there != room) return there;
  }
  return none;
}

/// The gaps in one side of an outline, as metres along it.
struct Gap {
  double begin = 0, end = 0;
};
std::vector<Gap> gaps_of(const path::FloorMap& map, Vec2 from, Vec2 along, double length,
                         Vec2 outward) {
  std::vector<Gap> gaps;
  for (double at = step / 2; at < length; at += step) {
    if (!is_open(map, from + at * along, outward)) continue;
    const double begin = at - step / 2, end = at + step / 2;
    if (!gaps.empty() && begin - gaps.back().end <= column)
      gaps.back().end = end;
    else
      gaps.push_back({begin, end});
  }
  std::erase_if(gaps, [](const Gap& gap) { return gap.end - gap.begin < narrowest; });
  return gaps;
}

void add_doorways(const Museum& museum, const path::FloorMap& map, std::uint32_t room,
                  std::vector<Doorway>& out) {
  const std::vector<Vec2>& outline = museum.rooms[room].outline;
  const double turn = signed_area(outline) < 0 ? 1 : -1;  // outward is to the right of each side
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 from = outline[i], to = outline[(i + 1) % outline.size()];
    const double length = glm::distance(from, to);
    if (length < narrowest) continue;
    const Vec2 along = (to - from) / length, outward = turn * left_of(along);
    for (const Gap& gap : gaps_of(map, from, along, length, outward)) {
      Doorway doorway{.middle = from + (gap.begin + gap.end) / 2 * along,
                      .outward = outward,
                      .width = gap.end - gap.begin};
      doorway.beyond = beyond(museum, map, room, doorway);
      out.push_back(doorway);
    }
  }
}

/// The share of the piece of a way at which it goes through a doorway; none: beside it.
std::optional<double> crossing(Vec2 from, Vec2 to, const Doorway& door) noexcept {
  const Vec2 walked = to - from;
  const double through = dot(walked, door.outward);
  if (std::abs(through) < 1e-9) return {};  // along it
  const double share = dot(door.middle - from, door.outward) / through;
  if (share < 0 || share >= 1) return {};
  const Vec2 beside = from + share * walked - door.middle;
  if (std::abs(cross(door.outward, beside)) > door.width / 2) return {};
  return share;
}

/// Of doors as close as the two sides of a wall the first stays.
void join_sides_of_walls(std::vector<PassedDoor>& doors) {
  constexpr double thickest_wall = 1.2;
  std::ranges::sort(doors, {}, &PassedDoor::along);
  const auto same = std::ranges::unique(doors, [](const PassedDoor& a, const PassedDoor& b) {
    return glm::distance(a.middle, b.middle) < thickest_wall;
  });
  doors.erase(same.begin(), same.end());
}

}  // namespace

Doorways find_doorways(const Museum& museum,
                       std::span<const std::shared_ptr<const path::FloorMap>> maps) {
  Doorways doorways;
  for (std::uint32_t room = 0; room < museum.rooms.size(); ++room) {
    if (museum.rooms[room].floor < maps.size())
      add_doorways(museum, *maps[museum.rooms[room].floor], room, doorways.doorway);
    doorways.first.push_back(static_cast<std::uint32_t>(doorways.doorway.size()));
  }
  return doorways;
}

std::vector<PassedDoor> doors_along(const Museum& museum, const Doorways& doorways,
                                    std::uint32_t floor, std::span<const Vec2> way) {
  std::vector<PassedDoor> doors;
  double before = 0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double length = glm::distance(way[i - 1], way[i]);
    for (std::uint32_t room = 0; room < museum.rooms.size(); ++room) {
      if (museum.rooms[room].floor != floor) continue;
      for (const Doorway& door : doorways.of(room))
        if (const auto share = crossing(way[i - 1], way[i], door); share && door.is_door())
          doors.push_back(
              {.middle = door.middle,
               .through = dot(way[i] - way[i - 1], door.outward) > 0 ? door.outward : -door.outward,
               .width = door.width,
               .along = before + *share * length});
    }
    before += length;
  }
  join_sides_of_walls(doors);
  return doors;
}

}  // namespace docent::directions
