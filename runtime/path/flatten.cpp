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
  if (std::abs(to - from) <= same_angle) return append_point(corner.point_at(from, radius), points);
  // A chord of the angle a leaves its arc by radius * (1 - cos(a / 2)), less than radius * a^2 / 8.
  constexpr double widest_step = std::numbers::pi / 12;
  const double step = std::min(widest_step, std::sqrt(8 * flatness / radius));
  const double pieces = std::max(1.0, std::ceil(std::abs(to - from) / step - same_angle));
  const double turn = (to - from) / pieces, cosine = std::cos(turn), sine = std::sin(turn);
  Vec2 out = radius * corner.direction_at(from);
  append_point(corner.position + out, points);
  for (int i = 0; i < static_cast<int>(pieces); ++i) {
    out = cosine * out + sine * left_of(out);
    append_point(corner.position + out, points);
  }
}

}  // namespace docent::path
