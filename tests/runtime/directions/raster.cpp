#include "tests/runtime/directions/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace docent::test {
namespace {

constexpr double in_degrees = 180 / std::numbers::pi;

/// Even-odd, of any rings: how often a ray to the west crosses a side.
bool is_within(const std::vector<std::vector<Vec2>>& rings, Vec2 p) {
  int crossings = 0;
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if (std::min(a.y, b.y) > p.y || std::max(a.y, b.y) <= p.y) continue;
      if (std::lerp(a.x, b.x, (p.y - a.y) / (b.y - a.y)) < p.x) ++crossings;
    }
  return crossings % 2 == 1;
}

/// Degrees from one bearing to another, to the left, in (-180, 180].
double turn(double from, double to) {
  return std::remainder(to - from, 360.0);
}

directions::Side side_of(Vec2 at, double degrees, const WaterDoor& door) {
  using directions::Side;
  const Vec2 to = door.middle - at;
  const double far = std::hypot(to.x, to.y);
  const double where = turn(degrees, std::atan2(to.y, to.x) * in_degrees) / in_degrees;
  const double left = far * std::sin(where), ahead = far * std::cos(where);
  const double wall = turn(degrees, door.bearing);
  if (std::abs(wall) <= 45.01) return Side::Ahead;
  if (std::abs(wall) >= 134.99)
    return std::abs(left) <= 1 ? Side::Behind : left > 0 ? Side::BehindLeft : Side::BehindRight;
  if (ahead < -0.5) return wall > 0 ? Side::BehindLeft : Side::BehindRight;
  return wall > 0 ? Side::Left : Side::Right;
}

double order_of(Vec2 at, double degrees, const WaterDoor& door, directions::Side side) {
  const Vec2 to = door.middle - at;
  const double far = std::hypot(to.x, to.y);
  const double where = turn(degrees, std::atan2(to.y, to.x) * in_degrees) / in_degrees;
  if (side == directions::Side::Ahead) return -far * std::sin(where);
  if (side == directions::Side::Left || side == directions::Side::Right)
    return far * std::cos(where);
  return far;
}

}  // namespace

Raster::Raster(const Museum& museum, std::uint32_t floor) {
  const FloorPlan& plan = museum.floors[floor].plan;
  std::vector<std::vector<Vec2>> walls;
  Vec2 high = low_ = plan.vertex.front();
  for (const Ring& ring : plan.ring) {
    auto& line = walls.emplace_back();
    for (std::uint32_t i = 0; i < ring.count; ++i) line.push_back(plan.vertex[ring.first + i]);
  }
  for (const Vec2 v : plan.vertex) {
    low_ = glm::min(low_, v);
    high = glm::max(high, v);
  }
  low_ -= Vec2{0.5, 0.5};
  columns_ = std::lround((high.x - low_.x) / cell) + 5;
  rows_ = std::lround((high.y - low_.y) / cell) + 5;
  for (long row = 0; row < rows_; ++row)
    for (long column = 0; column < columns_; ++column) {
      const Vec2 at = centre(column, row);
      open_.push_back(is_within(walls, at) ? 1 : 0);
      std::uint32_t in = none;
      for (std::uint32_t r = 0; r < museum.rooms.size() && in == none; ++r)
        if (museum.rooms[r].floor == floor && is_within({museum.rooms[r].outline}, at)) in = r;
      room_.push_back(in);
    }
  doors_.resize(museum.rooms.size());
  for (std::uint32_t r = 0; r < museum.rooms.size(); ++r)
    if (museum.rooms[r].floor == floor) find_doors(r);
}

std::uint32_t Raster::room_at(Vec2 point) const {
  const long column = std::lround(std::floor((point.x - low_.x) / cell));
  const long row = std::lround(std::floor((point.y - low_.y) / cell));
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return none;
  return open_[index(column, row)] != 0 ? room_[index(column, row)] : none;
}

/// A sliver between an outline and a curved wall: a little floor that leads to no other room.
bool Raster::is_puddle(std::size_t start, std::uint32_t room) const {
  constexpr std::size_t sea = 300;  // cells
  std::vector<std::size_t> water{start};
  for (std::size_t i = 0; i < water.size() && water.size() < sea; ++i)
    for (const std::size_t next :
         {water[i] - 1, water[i] + 1, water[i] - static_cast<std::size_t>(columns_),
          water[i] + static_cast<std::size_t>(columns_)}) {
      if (open_[next] == 0 || room_[next] == room) continue;
      if (room_[next] != none) return false;
      if (std::ranges::find(water, next) == water.end()) water.push_back(next);
    }
  return water.size() < sea;
}

void Raster::find_doors(std::uint32_t room) {
  constexpr std::array<std::array<long, 2>, 4> beside{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  std::vector<char> seen(open_.size(), 0);
  std::vector<std::array<long, 2>> shore;
  std::vector<char> is_shore(open_.size(), 0);
  for (long row = 1; row + 1 < rows_; ++row)
    for (long column = 1; column + 1 < columns_; ++column) {
      if (open_[index(column, row)] == 0 || room_[index(column, row)] != room) continue;
      for (const auto& [x, y] : beside) {
        const std::size_t next = index(column + x, row + y);
        if (open_[next] == 0 || room_[next] == room || is_shore[index(column, row)] != 0) continue;
        if (room_[next] == none && is_puddle(next, room)) continue;
        is_shore[index(column, row)] = 1;
        shore.push_back({column, row});
      }
    }
  for (const auto& start : shore) {
    if (seen[index(start[0], start[1])] != 0) continue;
    std::vector<std::array<long, 2>> pool{start};
    seen[index(start[0], start[1])] = 1;
    Vec2 sum{}, out{};
    for (std::size_t i = 0; i < pool.size(); ++i) {
      const auto [column, row] = pool[i];
      sum += centre(column, row);
      for (const auto& [x, y] : beside) {
        const std::size_t next = index(column + x, row + y);
        if (open_[next] != 0 && room_[next] != room)
          out += Vec2{static_cast<double>(x), static_cast<double>(y)};
      }
      for (long x = -1; x <= 1; ++x)
        for (long y = -1; y <= 1; ++y) {
          const std::size_t next = index(column + x, row + y);
          if (is_shore[next] == 0 || seen[next] != 0) continue;
          seen[next] = 1;
          pool.push_back({column + x, row + y});
        }
    }
    const auto count = static_cast<double>(pool.size());
    if (count * cell < 0.5) continue;
    doors_[room].push_back({sum / count, std::atan2(out.y, out.x) * in_degrees, count * cell});
  }
}

Raster::Told Raster::tell(const std::vector<Vec2>& way, double degrees) const {
  struct Visit {
    std::uint32_t room;
    Vec2 in, out;
    double metres;
  };
  std::vector<Visit> visits;
  for (std::size_t i = 1; i < way.size(); ++i)
    for (int k = 0; k <= 200; ++k) {
      const Vec2 at = glm::mix(way[i - 1], way[i], k / 200.0);
      const std::uint32_t room = room_at(at);
      if (room == none) continue;
      if (visits.empty() || visits.back().room != room) visits.push_back({room, at, at, 0});
      visits.back().metres += glm::distance(at, visits.back().out);
      visits.back().out = at;
    }
  for (std::size_t i = 1; i + 1 < visits.size();)
    if (visits[i].metres < 0.7)
      visits.erase(visits.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  for (std::size_t i = 1; i < visits.size();)
    if (visits[i].room == visits[i - 1].room) {
      visits[i - 1].out = visits[i].out;
      visits.erase(visits.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  const auto door_at = [&](std::uint32_t room, Vec2 at) {
    const WaterDoor* nearest = nullptr;
    for (const WaterDoor& door : doors_[room])
      if (nearest == nullptr || glm::distance(door.middle, at) < glm::distance(nearest->middle, at))
        nearest = &door;
    return nearest;
  };
  Told told{.steps = {}, .at = way.front(), .degrees = degrees};
  if (visits.empty()) return told;
  told.first_room = visits.front().room;
  const WaterDoor* entry = nullptr;
  for (std::size_t i = 1; i < visits.size(); ++i) {
    const std::uint32_t here = visits[i - 1].room;
    directions::DoorStep step{.from = here, .to = visits[i].room};
    if (const WaterDoor* exit = door_at(here, visits[i - 1].out); exit != nullptr) {
      const auto count = [&](Vec2 at, double looking) {
        directions::DoorStep said = step;
        said.side = side_of(at, looking, *exit);
        const double place = order_of(at, looking, *exit, said.side);
        if (exit->width > 4) return said;
        for (const WaterDoor& door : doors_[here]) {
          if (door.width > 4 || &door == entry) continue;
          if (side_of(at, looking, door) != said.side) continue;
          ++said.of;
          if (order_of(at, looking, door, said.side) <= place) ++said.nth;
        }
        return said;
      };
      const directions::DoorStep whole = count(told.at, told.degrees);
      for (const Vec2 off : {Vec2{0.15, 0}, Vec2{-0.15, 0}, Vec2{0, 0.15}, Vec2{0, -0.15}})
        for (const double more : {-1.0, 1.0})
          if (!(count(told.at + off, told.degrees + more) == whole)) told.is_borderline = true;
      step = whole;
    }
    told.steps.push_back(step);
    entry = door_at(visits[i].room, visits[i].in);
    if (entry == nullptr) continue;
    told.at = entry->middle;
    told.degrees = entry->bearing + 180;
  }
  return told;
}

}  // namespace docent::test
