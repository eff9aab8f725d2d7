#include "runtime/crowd/find_refuge.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/model/geometry/polyline.h"
#include "runtime/path/floor_map.h"

namespace docent::crowd {
namespace {

constexpr double ring_step = 0.2;  // metres
constexpr int rings = 30;          // so a refuge is at most 6 m away
constexpr int directions = 24;
constexpr double refuge_spare = 0.08;       // metres kept from the line and from others
constexpr double refuge_wall_spare = 0.02;  // metres

bool is_taken(const ReservationTable& reservations, std::uint32_t body, Vec2 place,
              double distance) {
  return std::ranges::any_of(reservations.entries(), [&](const ReservationTable::Entry& entry) {
    return entry.body != body && glm::distance(entry.trajectory.place.back(), place) < distance;
  });
}

}  // namespace

std::vector<Refuge> find_refuges(const path::FloorMap& map, const ReservationTable& reservations,
                                 std::uint32_t body, Vec2 from, std::span<const Vec2> line,
                                 std::size_t most) {
  const double radius = reservations.body_radius(), apart = 2 * radius + refuge_spare;
  std::vector<std::pair<double, Refuge>> found;
  for (int ring = 1; ring <= rings && found.size() < most; ++ring)
    for (int i = 0; i < directions; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5 * (ring % 2)) / directions;
      const Vec2 place = from + ring_step * ring * Vec2(std::cos(angle), std::sin(angle));
      if (!map.has_room(place, radius + refuge_wall_spare) ||
          distance_to_polyline(place, line) < apart || is_taken(reservations, body, place, apart))
        continue;
      path::RouteQuery query{
          .from = from, .to = place, .radius = radius + refuge_wall_spare, .tell_clearance = false};
      path::Way way = path::route(map, query);
      if (way.status != path::RouteStatus::Ok || way.length > 2.5 * ring_step * ring + 0.5)
        continue;
      found.emplace_back(way.length, Refuge{place, std::move(way.points)});
    }
  std::ranges::stable_sort(found, {}, &std::pair<double, Refuge>::first);
  if (found.size() > most) found.resize(most);
  std::vector<Refuge> out;
  for (auto& [length, refuge] : found) out.push_back(std::move(refuge));
  return out;
}

}  // namespace docent::crowd
