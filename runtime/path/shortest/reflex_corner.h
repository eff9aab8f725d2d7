#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/path/shortest/arc_angle.h"

namespace docent::path {

/// Angles on a corner's circle that differ by less count as the same: a way that touches three
/// corners in a straight line leaves the middle one where it arrives, whatever the rounding.
/// Radians.
inline constexpr double same_angle = 1e-9;

/// The sense in which a way goes round a corner.
enum class Sense : std::uint8_t { CounterClockwise, Clockwise };

constexpr double sign_of(Sense sense) noexcept {
  return sense == Sense::CounterClockwise ? 1.0 : -1.0;
}

/// A corner that juts into the floor. The centre of a disc that rolls round it turns from the
/// normal of the wall that begins here, counter-clockwise, to the normal of the wall that ends
/// here.
struct ReflexCorner {
  std::uint32_t vertex = 0;
  Vec2 position{};
  Vec2 begin{};       ///< Unit normal of the wall that begins at the corner.
  double extent = 0;  ///< Radians from `begin` to the other normal, in (0, pi).

  /// The angle of a unit direction from `begin`, in (-pi/2, 3 pi/2].
  double angle_of(Vec2 direction) const noexcept {
    const double angle = std::atan2(cross(begin, direction), dot(begin, direction));
    return angle < -std::numbers::pi / 2 ? angle + 2 * std::numbers::pi : angle;
  }
  /// The unit direction at an angle from `begin`.
  Vec2 direction_at(double angle) const noexcept { return turned_by(begin, angle); }
  /// The point of the circle of `radius` at an angle from `begin`.
  Vec2 point_at(double angle, double radius) const noexcept {
    return position + radius * direction_at(angle);
  }
};

/// The corner at a vertex, if it is reflex.
std::optional<ReflexCorner> reflex_corner(const FloorPlan& plan, std::uint32_t before,
                                          std::uint32_t vertex);

/// The straight line that leaves one circle and arrives at another, as a way goes round them in the
/// given senses; a point is a circle of radius 0. Both circles are to the left of it where the
/// sense is counter-clockwise, to the right where it is clockwise.
struct TangentLine {
  Vec2 direction{};  ///< Unit.
  Vec2 left{};       ///< Unit, direction turned to the left.
};

/// The tangent from a circle about `from` to one about `to`. `from_left` is how far the first
/// centre lies to the left of the line (the radius, or minus it for clockwise, or 0 for a point),
/// `to_left` likewise. None where one circle lies across the other; where they miss that by
/// `slack` or less the line is taken as touching.
inline std::optional<TangentLine> tangent_line(Vec2 from, double from_left, Vec2 to, double to_left,
                                               double slack) noexcept {
  const Vec2 between = to - from;
  const double distance = std::sqrt(dot(between, between));
  if (!(distance > 0)) return {};
  double sine = to_left - from_left;
  if (std::abs(sine) > distance + slack) return {};
  sine = std::min(1.0, std::max(-1.0, sine / distance));
  const double cosine = std::sqrt(1 - sine * sine);
  const Vec2 unit = between / distance;
  // The line's left normal n has between . n = to_left - from_left.
  const Vec2 direction = cosine * unit - sine * left_of(unit);
  return TangentLine{direction, left_of(direction)};
}

}  // namespace docent::path
