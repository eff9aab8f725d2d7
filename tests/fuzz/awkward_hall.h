#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "content/import/floor/imported_plan.h"
#include "tests/fuzz/bytes.h"

namespace docent::test {

constexpr Vec2 hall_size{12, 8};  ///< Metres.

/// Draws a hall with obstacles as awkward as a plan may hold them. Most stand on a grid of 5 cm, so
/// that corners touch, line up and lie on one circle.
class AwkwardHall {
 public:
  explicit AwkwardHall(Bytes& bytes) : bytes_(bytes) {}

  import::ImportedPlan draw() {
    import::ImportedPlan plan;
    plan.files = {"fuzz"};
    import::ImportedPolygon& hall = plan.polygons.emplace_back();
    hall.outer = ring_of({{0, 0}, {hall_size.x, 0}, hall_size, {0, hall_size.y}});
    const unsigned obstacles = bytes_.below(most_obstacles + 1);
    for (unsigned i = 0; i < obstacles; ++i) {
      last_ = obstacle();
      hall.holes.push_back(ring_of(last_));
    }
    return plan;
  }

 private:
  using Points = std::vector<Vec2>;
  static constexpr unsigned most_obstacles = 10;

  static import::ImportedRing ring_of(const Points& points) {
    return {.vertex = points, .place = std::vector<import::SourcePlace>(points.size())};
  }

  Points obstacle() {
    switch (bytes_.below(6)) {
      case 0:
        return column();
      case 1:
        return needle();
      case 2:
        return sliver();
      case 3:
        return wedge();
      case 4:
        return zigzag();
      default:
        return touching();
    }
  }

  /// Also a little outside of the hall.
  Vec2 grid_point() {
    const unsigned x = bytes_.below(251), y = bytes_.below(171);
    return {0.05 * x - 0.25, 0.05 * y - 0.25};
  }
  Vec2 direction() {
    const double angle = 2 * std::numbers::pi * bytes_.byte() / 240;
    return {std::cos(angle), std::sin(angle)};
  }
  /// From a quarter of a millimetre to 10 cm.
  double thinness() { return 0.00025 * std::exp2(bytes_.below(10)); }

  Points column() {
    const Vec2 middle = grid_point();
    const double radius = 0.05 * (1 + bytes_.below(30));
    const unsigned corners = 3 + bytes_.below(10), turned = bytes_.below(24);
    Points points;
    for (unsigned i = 0; i < corners; ++i) {
      const double angle =
          2 * std::numbers::pi * (i / static_cast<double>(corners) + turned / 24.0);
      points.push_back(middle + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    return points;
  }

  /// A long triangle with one very sharp tip.
  Points needle() {
    const Vec2 base = grid_point(), along = direction();
    const double length = 0.1 * (1 + bytes_.below(60)), half = thinness() / 2;
    const Vec2 across = half * Vec2{-along.y, along.x};
    return {base - across, base + across, base + length * along};
  }

  /// A long, thin wall.
  Points sliver() {
    const Vec2 base = grid_point(), along = direction();
    const double length = 0.1 * (1 + bytes_.below(60));
    const Vec2 across = thinness() * Vec2{-along.y, along.x};
    return {base, base + length * along, base + length * along + across, base + across};
  }

  /// Any triangle of the grid: many have a sharp tip.
  Points wedge() { return {grid_point(), grid_point(), grid_point()}; }

  /// A ring that may cross itself.
  Points zigzag() {
    Points points(3 + bytes_.below(5));
    for (Vec2& point : points) point = grid_point();
    return points;
  }

  /// The last obstacle again, with a corner where another of its corners was, or nearly so.
  Points touching() {
    if (last_.empty()) return column();
    const unsigned count = static_cast<unsigned>(last_.size());
    const Vec2 from = last_[bytes_.below(count)], to = last_[bytes_.below(count)];
    Vec2 moved = to - from;
    if (bytes_.below(4) != 0) {
      const Vec2 away = direction();
      moved += thinness() * away;
    }
    Points points = last_;
    for (Vec2& point : points) point += moved;
    return points;
  }

  Bytes& bytes_;
  Points last_;
};

}  // namespace docent::test
