#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "runtime/model/geometry/bisector.h"
#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/geometry/voronoi_diagram.h"

namespace docent::path {

/// The curve of a Voronoi edge, with the distance to its two sites along it.
///
/// A place on it is a number between `begin` (the edge's `from`) and `end` (its `to`). On a line it
/// is metres from `from`, on a parabola its parameter (see Parabola).
class EdgeCurve {
 public:
  EdgeCurve(const FloorPlan& plan, const VoronoiDiagram& diagram, const VoronoiEdge& edge);

  double begin() const noexcept { return begin_; }
  double end() const noexcept { return end_; }

  Vec2 point_at(double place) const noexcept;
  double clearance_at(double place) const noexcept;
  /// Arc length between two places, exact.
  double length_between(double a, double b) const noexcept;
  /// The smallest clearance between two places, exact.
  double clearance_between(double a, double b) const noexcept;
  /// The place nearest to a point.
  double nearest_place(Vec2 point) const noexcept;
  /// The place, between the ends, where the clearance is smallest.
  double lowest_place() const noexcept;
  /// The place between a and b where the clearance is `level`, given that the clearance only grows
  /// or only falls from a to b, from one side of `level` to the other.
  double place_of_clearance(double level, double a, double b) const noexcept;
  /// Appends points from place a to place b, both included, within `flatness` of the curve.
  void append_points(double a, double b, std::vector<Vec2>& points) const;
  /// The same without the ends.
  void append_inner_points(double a, double b, std::vector<Vec2>& points) const;

  Vec2 low() const noexcept { return low_; }    ///< Corner of its bounding box.
  Vec2 high() const noexcept { return high_; }  ///< Corner of its bounding box.

 private:
  enum class Kind : unsigned char {
    Linear,   ///< A line; the clearance changes evenly.
    Corners,  ///< A line between two corners: clearance hypot(half distance, x - middle).
    Parabola,
  };
  double clamped(double place) const noexcept;

  Kind kind_ = Kind::Linear;
  double begin_ = 0, end_ = 0;
  Parabola parabola_;                       ///< Parabola only.
  Vec2 origin_{}, along_{1, 0};             ///< Lines only.
  double middle_ = 0;                       ///< Corners: the place midway between them.
  double half_distance_ = 0;                ///< Corners: half the distance between them.
  double begin_clearance_ = 0, slope_ = 0;  ///< Linear.
  Vec2 low_{}, high_{};
};

}  // namespace docent::path
