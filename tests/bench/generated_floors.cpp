#include "tests/bench/generated_floors.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/halls.h"

namespace docent::bench {
namespace {

using Ring = std::vector<Vec2>;
using std::numbers::pi;

constexpr double hall = 12;             // Metres from the middle of a wall to the next.
constexpr double half_wall = 0.15;      // Metres.
constexpr double half_door = 1.1;       // Metres.
constexpr double walls_of_a_hall = 34;  // On average.
constexpr double slant = 0.3;           // Radians.

/// Clockwise, as things that stand on a floor are.
Ring turned(Ring ring, Vec2 centre, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vec2& p : ring) p = centre + Vec2{c * p.x - s * p.y, s * p.x + c * p.y};
  return ring;
}

/// The walls about a place where four halls meet, up to the doors.
Ring crossing_walls(Vec2 centre) {
  const double a = half_wall, b = hall / 2 - half_door;
  return turned({{a, a},
                 {b, a},
                 {b, -a},
                 {a, -a},
                 {a, -b},
                 {-a, -b},
                 {-a, -a},
                 {-b, -a},
                 {-b, a},
                 {-a, a},
                 {-a, b},
                 {a, b}},
                centre, 0);
}

Ring box(Vec2 half) {
  return {{-half.x, -half.y}, {-half.x, half.y}, {half.x, half.y}, {half.x, -half.y}};
}

Ring column(double radius, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = -2 * pi * i / corners;
    ring.push_back(radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

/// A case or a column, within 1.6 m of its place.
Ring exhibit(Vec2 centre, std::mt19937_64& random) {
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution(a, b)(random);
  };
  const double width = between(0.4, 1.1), depth = between(0.4, 1.1), angle = between(0, pi);
  switch (random() % 4) {
    case 0:
      return turned(box({width, depth}), centre, 0);
    case 1:
      return turned(box({width, depth}), centre, angle);
    case 2:
      return turned({{-1, -1}, {-1, 1}, {-0.4, 1}, {-0.4, -0.4}, {1, -0.4}, {1, -1}}, centre, 0);
    default:
      return turned(column(width, 8), centre, angle);
  }
}

double on_grid(double metres) {
  return std::round(metres * 1e4) / 1e4;
}

}  // namespace

FloorPlan generated_museum(std::size_t walls, Turn turn) {
  const int columns =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(walls) / walls_of_a_hall)));
  const int rows = std::max(
      1, static_cast<int>(std::lround(static_cast<double>(walls) / walls_of_a_hall / columns)));
  std::mt19937_64 random(7);
  test::HallMaker maker;
  maker.room({0, 0}, {columns * hall, rows * hall});
  for (int y = 1; y < rows; ++y)
    for (int x = 1; x < columns; ++x) maker.ring(crossing_walls({x * hall, y * hall}));
  for (int y = 0; y < 2 * rows; ++y)
    for (int x = 0; x < 2 * columns; ++x)
      maker.ring(exhibit({hall / 4 + x * hall / 2, hall / 4 + y * hall / 2}, random));

  FloorPlan plan = std::move(maker.plan);
  plan.name = fmt::format("generated-{}", walls);
  if (turn == Turn::Slanting) plan.vertex = turned(std::move(plan.vertex), {}, slant);
  for (Vec2& p : plan.vertex) p = {on_grid(p.x), on_grid(p.y)};
  return plan;
}

Corridor zigzag_corridor(std::size_t turns) {
  constexpr Vec2 half_height{0, 1.2};
  Corridor corridor;
  for (std::size_t i = 0; i < turns; ++i)
    corridor.turns.emplace_back(6.0 * static_cast<double>(i), i % 2 == 0 ? 0.0 : 8.0);
  Ring ring;
  for (const Vec2 p : corridor.turns) ring.push_back(p - half_height);
  for (std::size_t i = turns; i-- > 0;) ring.push_back(corridor.turns[i] + half_height);
  corridor.plan = test::HallMaker().ring(ring).plan;
  corridor.plan.name = "zigzag";
  return corridor;
}

Corridor spiral_corridor(std::size_t turns) {
  constexpr double pitch = 3, half_width = 1;
  Corridor corridor;
  Ring left_side, right_side;
  Vec2 at{}, direction{1, 0};
  for (std::size_t i = 0; i < turns; ++i) {
    // Both sides meet at 45 degrees; at the two ends this cuts the corridor off slantwise.
    const Vec2 inwards = half_width * (left_of(direction) - direction);
    corridor.turns.push_back(at);
    left_side.push_back(at + inwards);
    right_side.push_back(at - inwards);
    direction = left_of(direction);
    const std::size_t pitches = i / 2 + 1;
    at += pitch * static_cast<double>(pitches) * direction;
  }
  right_side.insert(right_side.end(), left_side.rbegin(), left_side.rend());
  corridor.plan = test::HallMaker().ring(right_side).plan;
  corridor.plan.name = "spiral";
  return corridor;
}

}  // namespace docent::bench
