#include "runtime/model/geometry/hung_leaf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/model/geometry/door_leaf.h"
#include "runtime/model/geometry/segment.h"

namespace docent {
namespace {

constexpr double widest_angle = 1.7;  ///< Radians that a leaf opens.

}  // namespace

Vec2 direction_of(const HungLeaf& leaf, double angle) noexcept {
  return std::cos(angle) * leaf.along + std::sin(angle) * leaf.across;
}

double angle_clear_of(const HungLeaf& leaf, Vec2 middle, double radius) noexcept {
  const Vec2 from = middle - leaf.hinge;
  const double x = dot(from, leaf.along), y = dot(from, leaf.across);
  const double distance = std::hypot(x, y);
  if (distance >= leaf.width + radius) return 0;
  const double bearing = std::atan2(y, x);
  // Who grazes the hinges: the nearer they are, the less it matters where the leaf is.
  if (distance <= radius)
    return std::clamp((bearing + std::numbers::pi / 2) * distance / radius, 0.0, widest_angle);
  const double reach = std::sqrt(distance * distance - radius * radius);
  // The leaf touches the disc, or only the leaf's end does.
  const double apart =
      reach <= leaf.width
          ? std::asin(radius / distance)
          : std::acos(std::clamp((leaf.width * leaf.width + distance * distance - radius * radius) /
                                     (2 * leaf.width * distance),
                                 -1.0, 1.0));
  return std::clamp(bearing + apart, 0.0, widest_angle);
}

double distance_to_leaf(const HungLeaf& leaf, double angle, Vec2 point) noexcept {
  return distance_to_segment(point, leaf.hinge,
                             leaf.hinge + leaf.width * direction_of(leaf, angle));
}

HungLeaves leaves_of(const FloorPlan& plan, const Door& door) noexcept {
  HungLeaves leaves;
  if (door.opens == DoorOpens::None || door.a == door.b) return leaves;
  const DoorLeaf reach = door_leaf(plan, door);
  const double length = glm::distance(reach.a.at, reach.b.at);
  const Vec2 along = (reach.b.at - reach.a.at) / length;
  const Vec2 left{-along.y, along.x};
  const double width = door.hinge == DoorHinge::Both ? length / 2 : length;
  if (door.hinge != DoorHinge::B) leaves.leaf[leaves.count++] = {reach.a.at, along, left, width};
  if (door.hinge != DoorHinge::A) leaves.leaf[leaves.count++] = {reach.b.at, -along, left, width};
  return leaves;
}

}  // namespace docent
