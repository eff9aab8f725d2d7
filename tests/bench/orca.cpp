#include "tests/bench/orca.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace docent::bench {
namespace {

/// Allowed are the velocities v with dot(v - point, normal) >= 0.
struct HalfPlane {
  Vec2 point{}, normal{};
  double depth(Vec2 v) const noexcept { return dot(point - v, normal); }
};

Vec2 turned_left(Vec2 v) noexcept {
  return {-v.y, v.x};
}

/// Half of what it takes to leave the truncated cone of velocities that lead to a meeting.
HalfPlane against_body(const OrcaBody& self, const OrcaBody& other, const OrcaSettings& settings) {
  const Vec2 apart = other.position - self.position, relative = self.velocity - other.velocity;
  const double reach = self.radius + other.radius, square = dot(apart, apart);
  const bool overlaps = square <= reach * reach;
  const double time = overlaps ? settings.step : settings.horizon;
  const Vec2 w = relative - apart / time;
  const double along = dot(w, apart), size = glm::length(w);
  if (overlaps || (along < 0 && along * along > reach * reach * size * size)) {
    const Vec2 normal = size > 1e-9 ? w / size : -apart / std::max(std::sqrt(square), 1e-9);
    return {self.velocity + 0.5 * (reach / time - size) * normal, normal};
  }
  const double leg = std::sqrt(square - reach * reach);
  // Along the nearer side of the cone, which is then to the right.
  const Vec2 side = cross(apart, w) > 0
                        ? Vec2{apart.x * leg - apart.y * reach, apart.x * reach + apart.y * leg}
                        : -Vec2{apart.x * leg + apart.y * reach, apart.y * leg - apart.x * reach};
  const Vec2 direction = side / square;
  const Vec2 out = dot(relative, direction) * direction - relative;
  return {self.velocity + 0.5 * out, turned_left(direction)};
}

std::optional<HalfPlane> against_wall(const OrcaBody& self, const OrcaWall& wall,
                                      const OrcaSettings& settings) {
  const Vec2 line = wall.b - wall.a;
  const double t =
      std::clamp(dot(self.position - wall.a, line) / std::max(dot(line, line), 1e-12), 0.0, 1.0);
  const Vec2 off = self.position - (wall.a + t * line);
  const double distance = glm::length(off);
  if (distance < 1e-9 || distance > self.radius + self.most_speed * settings.wall_horizon)
    return std::nullopt;
  const Vec2 normal = off / distance;
  return HalfPlane{-(distance - self.radius) / settings.wall_horizon * normal, normal};
}

/// The best velocity on the border of planes[i] that the planes before it allow.
std::optional<Vec2> on_border(std::span<const HalfPlane> planes, std::size_t i, Vec2 preferred,
                              double most_speed) {
  const HalfPlane& border = planes[i];
  const Vec2 direction = -turned_left(border.normal);
  const double middle = dot(border.point, direction);
  const double inside = middle * middle + most_speed * most_speed - dot(border.point, border.point);
  if (inside < 0) return std::nullopt;
  double low = -middle - std::sqrt(inside), high = -middle + std::sqrt(inside);
  for (std::size_t j = 0; j < i; ++j) {
    // dot(border.point + t direction - point_j, normal_j) >= 0
    const double slope = dot(direction, planes[j].normal), at = planes[j].depth(border.point);
    if (std::abs(slope) < 1e-9) {
      if (at > 0) return std::nullopt;
      continue;
    }
    if (slope > 0)
      low = std::max(low, at / slope);
    else
      high = std::min(high, at / slope);
    if (low > high) return std::nullopt;
  }
  const double t = std::clamp(dot(preferred - border.point, direction), low, high);
  return border.point + t * direction;
}

/// Where nothing is allowed: what goes least against any plane, on a fine polar grid.
Vec2 least_bad(std::span<const HalfPlane> planes, double most_speed) {
  constexpr int rings = 24, spokes = 72;
  Vec2 best{};
  double least = std::numeric_limits<double>::infinity();
  for (int ring = 0; ring <= rings; ++ring)
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const double angle = 2 * std::numbers::pi * spoke / spokes;
      const Vec2 v = most_speed * ring / rings * Vec2{std::cos(angle), std::sin(angle)};
      double worst = -std::numeric_limits<double>::infinity();
      for (const HalfPlane& plane : planes) worst = std::max(worst, plane.depth(v));
      if (worst < least) {
        least = worst;
        best = v;
      }
    }
  return best;
}

}  // namespace

Vec2 orca_velocity(std::span<const OrcaBody> bodies, std::size_t self, Vec2 preferred,
                   std::span<const OrcaWall> walls, const OrcaSettings& settings) {
  const OrcaBody& body = bodies[self];
  std::vector<HalfPlane> planes;
  for (const OrcaWall& wall : walls)
    if (const auto plane = against_wall(body, wall, settings)) planes.push_back(*plane);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (i != self) planes.push_back(against_body(body, bodies[i], settings));

  const double speed = glm::length(preferred);
  Vec2 velocity = speed > body.most_speed ? body.most_speed / speed * preferred : preferred;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes[i].depth(velocity) <= 0) continue;
    const auto next = on_border(planes, i, preferred, body.most_speed);
    if (!next) return least_bad(planes, body.most_speed);
    velocity = *next;
  }
  return velocity;
}

}  // namespace docent::bench
