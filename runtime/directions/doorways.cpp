#include "runtime/directions/doorways.h"

#include <algorithm>
#include <cmath>

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

}  // namespace docent::directions
