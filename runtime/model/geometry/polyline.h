#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "runtime/model/geometry/segment.h"

/// Lines from point to point, open, in metres.
namespace docent {

inline double polyline_length(std::span<const Vec2> line) noexcept {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
  return length;
}

/// How far along the line each of its points is.
inline std::vector<double> distances_along(std::span<const Vec2> line) {
  std::vector<double> along(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i)
    along[i] = along[i - 1] + glm::distance(line[i - 1], line[i]);
  return along;
}

/// Distance from a point to the nearest place of the line; infinite where the line is empty.
inline double distance_to_polyline(Vec2 point, std::span<const Vec2> line) noexcept {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < line.size(); ++i)
    nearest = std::min(
        nearest, nearest_on_segment(point, line[i > 0 ? i - 1 : 0], line[i]).distance_squared);
  return std::sqrt(nearest);
}

/// The point `along` metres along the line, clamped to its ends.
inline Vec2 point_along(std::span<const Vec2> line, double along) noexcept {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = glm::distance(line[i - 1], line[i]);
    if (along <= length)
      return length > 0 ? glm::mix(line[i - 1], line[i], std::max(along, 0.0) / length) : line[i];
    along -= length;
  }
  return line.empty() ? Vec2{} : line.back();
}

/// The line up to the point `along` metres along it, and the line from that point on.
inline std::vector<Vec2> first_part(std::span<const Vec2> line, double along) {
  std::vector<Vec2> out;
  double walked = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) walked += glm::distance(line[i - 1], line[i]);
    if (i > 0 && walked >= along) break;
    out.push_back(line[i]);
  }
  if (!line.empty()) out.push_back(point_along(line, along));
  return out;
}
inline std::vector<Vec2> last_part(std::span<const Vec2> line, double along) {
  const std::vector<Vec2> reversed(line.rbegin(), line.rend());
  std::vector<Vec2> out = first_part(reversed, std::max(0.0, polyline_length(line) - along));
  std::ranges::reverse(out);
  return out;
}

}  // namespace docent
