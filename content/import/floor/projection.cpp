#include "content/import/floor/projection.h"

#include <cmath>
#include <numbers>

namespace docent::import {
namespace {

constexpr double semi_major_axis = 6378137.0;         // Metres, WGS84.
constexpr double flattening = 1 / 298.257223563;      // WGS84.
constexpr double e2 = flattening * (2 - flattening);  // First eccentricity squared.
constexpr double second_e2 = e2 / (1 - e2);           // Second eccentricity squared.
constexpr double radians_per_degree = std::numbers::pi / 180;

/// Length along the meridian between two latitudes: Simpson's rule on the radius of curvature,
/// whose error is of the fifth power of the difference (below 1e-9 m over 20 km).
double meridian_arc(double from, double to) {
  const auto radius = [](double latitude) {
    const double s = std::sin(latitude);
    return semi_major_axis * (1 - e2) / std::pow(1 - e2 * s * s, 1.5);
  };
  return (to - from) * (radius(from) + 4 * radius((from + to) / 2) + radius(to)) / 6;
}

}  // namespace

LocalProjection::LocalProjection(Vec2 origin_degrees)
    : origin_(origin_degrees * radians_per_degree) {}

Vec2 LocalProjection::to_floor(Vec2 degrees) const noexcept {
  const Vec2 point = degrees * radians_per_degree;
  const double s = std::sin(point.y), c = std::cos(point.y);
  const double n = semi_major_axis / std::sqrt(1 - e2 * s * s);
  // The short way round the globe, so that a floor may lie across the 180th meridian.
  const double l = std::remainder(point.x - origin_.x, 2 * std::numbers::pi);
  const double cubic = l * l * (c * c - s * s + second_e2 * c * c * c * c) / 6;
  return {n * l * c * (1 + cubic), meridian_arc(origin_.y, point.y) + n * l * l * s * c / 2};
}

}  // namespace docent::import
