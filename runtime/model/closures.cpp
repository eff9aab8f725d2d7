#include "runtime/model/closures.h"

#include <algorithm>
#include <utility>

#include "runtime/model/geometry/polygon.h"
#include "runtime/model/none.h"

namespace docent {
namespace {

std::uint32_t room_at(const Museum& museum, std::uint32_t floor, Vec2 point) {
  for (std::uint32_t i = 0; i < museum.rooms.size(); ++i)
    if (museum.rooms[i].floor == floor && contains(museum.rooms[i].outline, point)) return i;
  return none;
}

bool has(const std::vector<std::uint32_t>& ascending, std::uint32_t value) {
  return std::ranges::binary_search(ascending, value);
}

}  // namespace

const ClosedExhibit* closed_exhibit(const Closures& closures, std::uint32_t exhibit) noexcept {
  const auto found =
      std::ranges::lower_bound(closures.exhibits, exhibit, {}, &ClosedExhibit::exhibit);
  const bool is_closed = found != closures.exhibits.end() && found->exhibit == exhibit;
  return is_closed ? &*found : nullptr;
}

ClosureRules::Sides rooms_beside(const Museum& museum, std::uint32_t floor, const Door& door) {
  constexpr double step = 0.05, thickest_wall = 1;  // metres
  ClosureRules::Sides sides{{none, none}};
  if (door.a == door.b) return sides;
  const Vec2 middle = 0.5 * (door.a + door.b);
  const Vec2 across = left_of(glm::normalize(door.b - door.a));
  for (std::size_t side = 0; side < 2; ++side)
    for (double way = step; way <= thickest_wall && sides.room[side] == none; way += step)
      sides.room[side] = room_at(museum, floor, middle + (side == 0 ? way : -way) * across);
  return sides;
}

template <typename T>
ClosureRules::Part ClosureRules::part(Closable what, const std::string& id, const T& thing) {
  Part part{.what = what, .id = &id, .closed = thing.closed, .hours = {}};
  if (!thing.hours.empty())
    if (auto hours = parse_opening_hours(thing.hours)) part.hours = std::move(*hours);
  return part;
}

ClosureRules::ClosureRules(const Museum& museum)
    : museum_(museum), holidays_(parse_dates(museum.holidays).value_or(std::vector<DateRange>{})) {
  for (std::uint32_t floor = 0; floor < museum.floors.size(); ++floor) {
    auto& parts = doors_.emplace_back();
    auto& sides = sides_.emplace_back();
    for (const Door& door : museum.floors[floor].plan.doors) {
      parts.push_back(part(Closable::Door, door.name, door));
      sides.push_back(rooms_beside(museum, floor, door));
    }
  }
  for (const Room& room : museum.rooms) rooms_.push_back(part(Closable::Room, room.id, room));
  for (const Connection& connection : museum.connections)
    connections_.push_back(part(Closable::Connection, connection.id, connection));
  for (const Exhibit& exhibit : museum.exhibits)
    exhibits_.push_back(part(Closable::Exhibit, exhibit.id, exhibit));
}

std::optional<ClosedUntil> ClosureRules::state(const Part& part, std::optional<LocalMinute> at,
                                               const Today& today) const {
  if (part.closed) return ClosedUntil{};
  std::optional<ClosedUntil> closed;
  for (const TodayClosure& entry : today.closed) {
    if (entry.what != part.what || entry.id != *part.id) continue;
    if (at && entry.until && *entry.until <= *at) continue;
    closed = ClosedUntil{entry.until, entry.reason.empty() ? nullptr : &entry.reason};
  }
  if (!at || !part.hours) return closed;
  // Live closures end and hours may then keep it closed.
  const LocalMinute then = closed && closed->until ? *closed->until : *at;
  if ((closed && !closed->until) || is_open(*part.hours, holidays_, then)) return closed;
  return ClosedUntil{next_change(*part.hours, holidays_, then), closed ? closed->reason : nullptr};
}

std::vector<std::uint32_t> ClosureRules::closed_of(std::span<const Part> parts,
                                                   std::optional<LocalMinute> at,
                                                   const Today& today) const {
  std::vector<std::uint32_t> closed;
  for (std::uint32_t i = 0; i < parts.size(); ++i)
    if (state(parts[i], at, today)) closed.push_back(i);
  return closed;
}

Closures ClosureRules::at(std::optional<LocalMinute> at, const Today& today) const {
  Closures closures;
  closures.rooms = closed_of(rooms_, at, today);
  closures.connections = closed_of(connections_, at, today);
  for (std::size_t floor = 0; floor < doors_.size(); ++floor) {
    auto& closed = closures.doors.emplace_back();
    for (std::uint32_t i = 0; i < doors_[floor].size(); ++i) {
      if (doors_[floor][i].closed) continue;
      const std::uint32_t left = sides_[floor][i].room[0], right = sides_[floor][i].room[1];
      const bool leads_to_closed =
          left != right && (has(closures.rooms, left) || has(closures.rooms, right));
      if (leads_to_closed || state(doors_[floor][i], at, today)) closed.push_back(i);
    }
  }
  for (std::uint32_t i = 0; i < exhibits_.size(); ++i) {
    const std::optional<ClosedUntil> closed = exhibit(i, at, today);
    if (!closed) continue;
    const LocalText* reason = closed->reason;
    closures.exhibits.push_back({i, closed->until, reason != nullptr ? *reason : LocalText{}});
    if (at && closed->until) closures.day = std::chrono::floor<std::chrono::days>(*at);
  }
  return closures;
}

std::optional<ClosedUntil> ClosureRules::exhibit(std::uint32_t exhibit,
                                                 std::optional<LocalMinute> at,
                                                 const Today& today) const {
  const std::uint32_t room = museum_.exhibits[exhibit].room;
  const auto by_room = room < rooms_.size() ? state(rooms_[room], at, today) : std::nullopt;
  const auto by_itself = state(exhibits_[exhibit], at, today);
  if (!by_room || !by_itself) return by_room ? by_room : by_itself;
  // Both: until the later.
  if (!by_itself->until || (by_room->until && *by_itself->until >= *by_room->until))
    return by_itself;
  return by_room;
}

}  // namespace docent
