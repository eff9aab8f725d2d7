#include "runtime/path/flatten.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/path/shortest/arc_angle.h"

namespace docent::path {

void append_point(Vec2 point, std::vector<Vec2>& points) {
  if (points.empty() || points.back() != point) points.push_back(point);
}

void append_arc(Vec2 centre, Vec2 begin, double radius, double from, double to,
                std::vector<Vec2>& points) {
  if (radius == 0) return append_point(centre, points);
  if (std::abs(to - from) <= same_angle)
    return append_point(centre + radius * turned_by(begin, from), points);
  // A chord of the angle a leaves its arc by radius * (1 - cos(a / 2)), less than radius * a^2 / 8.
  constexpr double widest_step = std::numbers::pi / 12;
  const double step = std::min(widest_step, std::sqrt(8 * flatness / radius));
  const double pieces = std::max(1.0, std::ceil(std::abs(to - from) / step - same_angle));
  const SineVersine turn = of_small_angle((to - from) / pieces);
  Vec2 out = radius * turned_by(begin, from);
  append_point(centre + out, points);
  for (int i = 0; i < static_cast<int>(pieces); ++i) {
    out += turn.sine * left_of(out) - turn.versine * out;
    append_point(centre + out, points);
  }
}

}  // namespace docent::path
