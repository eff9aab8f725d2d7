#include "runtime/path/closure/closed_doors.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/model/geometry/door_leaf.h"
#include "runtime/model/geometry/orientation.h"
#include "runtime/model/geometry/segment.h"
#include "runtime/model/none.h"
#include "runtime/path/touching.h"

namespace docent::path {
namespace {

/// How far a leaf reaches into its walls, as what the content compiler makes of a door that is
/// closed for good. Metres.
constexpr double hold = 0.005;
/// Flattened ways are within a millimetre of the true ones.
constexpr double flattening = 0.0012;
/// A point that rounds a corner goes round a circle that is too small to matter. Metres.
constexpr double point_circle = 1e-6;

/// Do the segments meet in a point inside both?
bool cross_inside(Vec2 p, Vec2 q, Vec2 a, Vec2 b) noexcept {
  return orientation(a, b, p) * orientation(a, b, q) < 0 &&
         orientation(p, q, a) * orientation(p, q, b) < 0;
}
/// Have they a point in common?
bool touch(Vec2 p, Vec2 q, Vec2 a, Vec2 b) noexcept {
  return segment_distance_squared(p, q, a, b) <= rounding * rounding;
}

}  // namespace

ClosedDoors::ClosedDoors(const FloorPlan& plan, const SightMap& sight, double slack,
                         const RoadGraph& roads, std::span<const std::uint32_t> doors)
    : slack_(slack) {
  for (const std::uint32_t door : doors)
    if (!plan.doors[door].closed) add(plan, door);
  if (leaf_.empty()) return;
  measure_landmarks(plan, sight);
  cut_roads(roads);
}

/// With the pairs of corners between which no leaf is.
void ClosedDoors::measure_landmarks(const FloorPlan& plan, const SightMap& sight) {
  SightMap open;
  open.corner = sight.corner;
  for (std::size_t i = 0; i < sight.corner.size(); ++i) {
    const Vec2 here = plan.vertex[sight.corner[i]];
    for (std::uint32_t k = sight.pair_first[i]; k < sight.pair_first[i + 1]; ++k) {
      const Vec2 there = plan.vertex[sight.corner[sight.pair_other[k]]];
      if (!blocks(here, there, 0)) open.pair_other.push_back(sight.pair_other[k]);
    }
    open.pair_first.push_back(static_cast<std::uint32_t>(open.pair_other.size()));
  }
  landmarks_.emplace(plan, open);
}

void ClosedDoors::add(const FloorPlan& plan, std::uint32_t index) {
  const Door& door = plan.doors[index];
  if (!crosses_floor(plan, door)) return;
  const DoorLeaf leaf = door_leaf(plan, door);
  const Vec2 into_wall = hold * glm::normalize(door.b - door.a);
  leaf_.push_back({leaf.a.at, leaf.b.at, leaf.a.at - into_wall, leaf.b.at + into_wall, index});
}

void ClosedDoors::cut_roads(const RoadGraph& roads) {
  std::vector<Vec2> points;
  cut_first_.push_back(0);
  for (std::uint32_t road = 0; road < roads.roads().size(); ++road) {
    points.clear();
    roads.append_between(roads.begin_of(road), roads.end_of(road), points);
    double before = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double length = glm::distance(points[i], points[i + 1]);
      for (const Leaf& leaf : leaf_)
        if (touch(points[i], points[i + 1], leaf.far_a, leaf.far_b)) {
          const double a = std::abs(cross(leaf.b - leaf.a, points[i] - leaf.a));
          const double b = std::abs(cross(leaf.b - leaf.a, points[i + 1] - leaf.a));
          cut_.push_back(before + (a + b > 0 ? a / (a + b) : 0.5) * length);
        }
      before += length;
    }
    std::sort(cut_.begin() + cut_first_.back(), cut_.end());
    cut_first_.push_back(static_cast<std::uint32_t>(cut_.size()));
  }
}

double ClosedDoors::distance(Vec2 point) const noexcept {
  double least = infinity;
  for (const Leaf& leaf : leaf_)
    least = std::min(least, nearest_on_segment(point, leaf.a, leaf.b).distance_squared);
  return std::sqrt(least);
}

double ClosedDoors::distance(Vec2 p, Vec2 q) const noexcept {
  double least = infinity;
  for (const Leaf& leaf : leaf_)
    least = std::min(least, segment_distance_squared(p, q, leaf.a, leaf.b));
  return std::sqrt(least);
}

bool ClosedDoors::has_room(Vec2 point, double radius) const noexcept {
  return radius == 0 || distance(point) >= least_clearance(radius);
}

bool ClosedDoors::blocks(Vec2 p, Vec2 q, double radius) const noexcept {
  const double reach = least_clearance(radius) - slack_;
  return std::ranges::any_of(leaf_, [&](const Leaf& leaf) {
    return radius == 0 ? cross_inside(p, q, leaf.far_a, leaf.far_b)
                       : segment_distance_squared(p, q, leaf.a, leaf.b) < reach * reach;
  });
}

bool ClosedDoors::may_block(std::span<const Vec2> points, double radius) const noexcept {
  const double reach = radius + flattening;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    for (const Leaf& leaf : leaf_)
      if (segment_distance_squared(points[i], points[i + 1], leaf.far_a, leaf.far_b) <
          reach * reach)
        return true;
  return false;
}

std::vector<std::uint32_t> ClosedDoors::crossed(std::span<const Vec2> points) const {
  std::vector<std::uint32_t> doors;
  for (const Leaf& leaf : leaf_)
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (touch(points[i], points[i + 1], leaf.far_a, leaf.far_b)) {
        doors.push_back(leaf.door);
        break;
      }
  std::ranges::sort(doors);
  return doors;
}

bool ClosedDoors::crosses(std::span<const Vec2> points) const noexcept {
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    for (const Leaf& leaf : leaf_)
      if (touch(points[i], points[i + 1], leaf.far_a, leaf.far_b)) return true;
  return false;
}

void ClosedDoors::cut_arcs(const ReflexCorner& corner, double radius,
                           std::vector<ArcInterval>& free) const {
  const double circle = radius == 0 ? point_circle : radius;
  const double rolling = rolling_radius(circle, slack_);
  const double reach = least_clearance(circle) - slack_;
  for (const Leaf& leaf : leaf_)
    docent::path::cut_arcs(corner, rolling, reach, leaf.a, leaf.b, free);
}

}  // namespace docent::path
