#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "runtime/scene/camera.h"
#include "tests/support/halls.h"

namespace docent::scene {

inline double number(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
}

inline Rect any_free() {
  const bool landscape = *rc::gen::arbitrary<bool>();
  return landscape ? Rect{0.37F, 0, 0.63F, 1} : Rect{0, 0, 1, 0.56F};
}
inline float aspect_of(const Rect& free) {
  return free.height < 1 ? 9.0F / 16 : 16.0F / 9;
}
inline bool is_in(const Rect& free, std::optional<ScreenPoint> at) {
  return at && at->x >= free.x && at->x <= free.x + free.width && at->y >= free.y &&
         at->y <= free.y + free.height;
}

/// A hall with partitions in it, and somebody's way through it.
struct WalkInHall {
  struct Box {
    Vec2 low, high;
  };
  FloorPlan plan;
  std::vector<Box> partitions;
  std::vector<Vec2> way;  ///< A point about every 5 cm.

  bool is_clear(Vec2 p, double room) const {
    if (p.x < room || p.y < room || p.x > 24 - room || p.y > 18 - room) return false;
    return std::ranges::none_of(partitions, [&](const Box& box) {
      return glm::distance(p, glm::clamp(p, box.low, box.high)) < room;
    });
  }
  Vec2 at(double metres) const {
    const double last = static_cast<double>(way.size() - 1);
    return way[static_cast<std::size_t>(std::clamp(metres / 0.05, 0.0, last))];
  }
  double length() const { return 0.05 * static_cast<double>(way.size() - 1); }
  std::vector<Vec2> ahead(double along) const {
    std::vector<Vec2> points;
    for (double metres = 1; metres <= view_ahead && along + metres < length() + 1; ++metres)
      points.push_back(at(along + metres));
    return points;
  }
};

/// Partitions 20 to 35 cm thick; a way that turns in bends of half a metre, and away from walls.
inline WalkInHall any_walk_in_a_hall(double metres) {
  constexpr double step = 0.05, body = 0.3, sharpest = step / 0.5;
  WalkInHall walk;
  test::HallMaker maker;
  maker.room({0, 0}, {24, 18});
  for (int i = *rc::gen::inRange(2, 9); i > 0; --i) {
    Vec2 size{number(2, 7), number(0.2, 0.35)};
    if (*rc::gen::arbitrary<bool>()) std::swap(size.x, size.y);
    const Vec2 low{number(1, 23 - size.x), number(1, 17 - size.y)};
    const bool touches = std::ranges::any_of(walk.partitions, [&](const WalkInHall::Box& other) {
      return low.x < other.high.x + 1 && other.low.x < low.x + size.x + 1 &&
             low.y < other.high.y + 1 && other.low.y < low.y + size.y + 1;
    });
    if (touches) continue;
    walk.partitions.push_back({low, low + size});
    maker.block(low, low + size);
  }
  walk.plan = maker.plan;
  do walk.way = {{number(0.5, 23.5), number(0.5, 17.5)}};
  while (!walk.is_clear(walk.way[0], body));
  double heading = number(-std::numbers::pi, std::numbers::pi), bend = 0;
  for (int i = 0; i < static_cast<int>(metres / step); ++i) {
    if (i % 40 == 0) bend = number(-1, 1) * sharpest * 0.5;
    heading += bend;
    for (int turn = 0; turn < 400; ++turn) {
      const Vec2 next = walk.way.back() + step * Vec2{std::cos(heading), std::sin(heading)};
      if (walk.is_clear(next, body)) {
        walk.way.push_back(next);
        break;
      }
      heading += bend < 0 ? -sharpest : sharpest;
    }
  }
  return walk;
}

}  // namespace docent::scene
