#pragma once

#include <cstddef>
#include <vector>

#include "content/import/floor/imported_plan.h"

namespace docent::test {

/// What drawn rings mean, taken literally: a point is floor where some area's outline winds about
/// it and no hole of that area does. An oracle for mending that builds no walls: winding numbers
/// along horizontal lines, by brute force.
class RawInterior {
 public:
  explicit RawInterior(const import::ImportedPlan& plan);

  [[nodiscard]] bool holds(Vec2 point) const;
  /// Square metres. Cuts the plane into strips between the heights at which sides begin, end and
  /// cross; within one, everything is made of trapezia. Exact but for rounding.
  [[nodiscard]] double area() const;
  /// Metres to the nearest side that was drawn.
  [[nodiscard]] double distance_to_sides(Vec2 point) const;
  /// Metres of all sides.
  [[nodiscard]] double length() const;

  [[nodiscard]] Vec2 low() const { return low_; }
  [[nodiscard]] Vec2 high() const { return high_; }

 private:
  struct Side {
    Vec2 a{}, b{};
    std::size_t ring = 0;
  };
  /// A side that a horizontal line crosses.
  struct Crossing {
    double x = 0;
    std::size_t ring = 0;
    int turn = 0;  ///< 1 where the ring goes up.
  };

  void add(const import::ImportedRing& ring);
  [[nodiscard]] std::vector<Crossing> crossings(double y) const;
  [[nodiscard]] std::vector<double> heights() const;
  [[nodiscard]] bool is_floor(const std::vector<int>& winding) const;
  [[nodiscard]] double width_at(double y) const;

  std::vector<Side> sides_;
  std::vector<std::vector<std::size_t>> rings_of_;  ///< Per polygon, the outline first.
  std::size_t rings_ = 0;
  Vec2 low_{}, high_{};
};

}  // namespace docent::test
