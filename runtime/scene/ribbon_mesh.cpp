#include "runtime/scene/ribbon_mesh.h"

#include <algorithm>
#include <cmath>

namespace docent::scene {
namespace {

/// Corners are rounded with this radius where their sides are long enough: more than half the
/// width, so that the inner edge does not fold, and small enough to stay clear of a wall that the
/// way passes at a body's radius.
constexpr double corner_radius = 0.22;
constexpr double nearest = 1e-4;  // metres; points closer than this are one

double length_of(Vec2 v) noexcept {
  return std::hypot(v.x, v.y);
}

void append(std::vector<Vec2>& points, Vec2 p) noexcept {
  if (points.size() == points.capacity()) return;
  if (points.empty() || length_of(p - points.back()) > nearest) points.push_back(p);
}

/// Replaces the corner at `b` by a quadratic curve that touches both of its sides.
void append_corner(std::vector<Vec2>& points, Vec2 a, Vec2 b, Vec2 c) noexcept {
  const double before = length_of(b - a);
  const double after = length_of(c - b);
  if (before <= nearest || after <= nearest) return append(points, b);
  const Vec2 in = (b - a) / before;
  const Vec2 on = (c - b) / after;
  const double turn = std::abs(std::atan2(cross(in, on), dot(in, on)));
  constexpr double straight = 0.05;  // radians
  if (turn < straight) return append(points, b);
  const double reach = std::min({corner_radius * std::tan(turn / 2), 0.45 * before, 0.45 * after});
  const int pieces = 2 + static_cast<int>(turn / 0.25);
  const Vec2 from = b - in * reach;
  const Vec2 to = b + on * reach;
  for (int i = 0; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    append(points, from * ((1 - t) * (1 - t)) + b * (2 * t * (1 - t)) + to * (t * t));
  }
}

void round_corners(std::span<const Vec2> points, std::vector<Vec2>& out) noexcept {
  out.clear();
  append(out, points.front());
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    append_corner(out, points[i - 1], points[i], points[i + 1]);
  append(out, points.back());
}

void append_pair(std::vector<RibbonVertex>& strip, Vec2 middle, Vec2 across,
                 double along) noexcept {
  if (strip.size() + 2 > strip.capacity()) return;
  constexpr double half = ribbon_half_width + ribbon_rim;
  for (const double side : {half, -half}) {
    const Vec2 p = middle + across * side;
    strip.push_back({{static_cast<float>(p.x), static_cast<float>(-p.y)},
                     {static_cast<float>(along), static_cast<float>(side)}});
  }
}

}  // namespace

std::size_t append_ribbon(std::span<const Vec2> points, double length, std::vector<Vec2>& rounded,
                          std::vector<RibbonVertex>& strip) noexcept {
  if (points.size() < 2) return 0;
  round_corners(points, rounded);
  if (rounded.size() < 2) return 0;
  double drawn = 0;
  for (std::size_t i = 1; i < rounded.size(); ++i) drawn += length_of(rounded[i] - rounded[i - 1]);
  const double scale = length > 0 ? length / drawn : 1;

  const std::size_t before = strip.size();
  constexpr double cap = ribbon_half_width + ribbon_rim;
  double along = 0;
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    const Vec2 in = rounded[std::max<std::size_t>(i, 1)] - rounded[std::max<std::size_t>(i, 1) - 1];
    const std::size_t next = std::min(i + 1, rounded.size() - 1);
    const Vec2 on = rounded[next] - rounded[next - 1];
    const Vec2 in_unit = in / length_of(in);
    const Vec2 on_unit = on / length_of(on);
    if (i > 0) along += length_of(in) * scale;
    const Vec2 normal = left_of(in_unit) + left_of(on_unit);
    // A mitre of at most 1.6 widths; only a way that turns back on itself would need more.
    const double size2 = dot(normal, normal);
    const Vec2 across =
        size2 > 1e-6 ? normal * std::min(2 / size2, 1.6 / std::sqrt(size2)) : left_of(in_unit);
    if (i == 0) append_pair(strip, rounded[0] - on_unit * cap, left_of(on_unit), -cap);
    append_pair(strip, rounded[i], across, along);
    if (i + 1 == rounded.size())
      append_pair(strip, rounded[i] + in_unit * cap, left_of(in_unit), along + cap);
  }
  return strip.size() - before;
}

}  // namespace docent::scene
