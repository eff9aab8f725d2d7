#include "runtime/path/flatten.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace docent::path {

void append_point(Vec2 point, std::vector<Vec2>& points) {
  if (points.empty() || points.back() != point) points.push_back(point);
}

void append_arc(const ReflexCorner& corner, double radius, double from, double to,
                std::vector<Vec2>& points) {
  if (radius == 0) return append_point(corner.position, points);
  constexpr double widest_step = std::numbers::pi / 12;
  const double step = std::min(widest_step, 2 * std::acos(1 - std::min(1.0, flatness / radius)));
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / step - same_angle)));
  if (std::abs(to - from) <= same_angle) return append_point(corner.point_at(from, radius), points);
  for (int i = 0; i <= pieces; ++i)
    append_point(corner.point_at(from + (to - from) * i / pieces, radius), points);
}

}  // namespace docent::path
