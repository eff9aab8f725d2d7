#include "content/floor/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "content/floor/mend.h"
#include "content/floor/ring_overlay.h"

namespace docent::floor {
namespace {

/// A point as its front sees it: metres to the right of its middle and towards its front.
Vec2 seen_from(const Footprint& footprint, Vec2 point) {
  const Vec2 front{std::cos(footprint.heading), std::sin(footprint.heading)};
  const Vec2 offset = point - footprint.centre;
  return {dot(offset, left_of(front)), dot(offset, front)};
}

/// How far two sets of corners reach into each other along an axis; negative where they are apart.
double overlap_along(Vec2 axis, const std::array<Vec2, 4>& a, const std::array<Vec2, 4>& b) {
  const auto reach = [&](const std::array<Vec2, 4>& corners) {
    std::array<double, 4> place{};
    std::ranges::transform(corners, place.begin(), [&](Vec2 c) { return dot(c, axis); });
    return std::ranges::minmax(place);
  };
  const auto [low_a, high_a] = reach(a);
  const auto [low_b, high_b] = reach(b);
  return std::min(high_a - low_b, high_b - low_a);
}

}  // namespace

std::array<Vec2, 4> corners_of(const Footprint& footprint) {
  const Vec2 front{std::cos(footprint.heading), std::sin(footprint.heading)};
  const Vec2 right = 0.5 * footprint.size.x * left_of(front), deep = 0.5 * footprint.size.y * front;
  const Vec2 c = footprint.centre;
  return {c + right + deep, c + right - deep, c - right - deep, c - right + deep};
}

bool covers(const Footprint& footprint, Vec2 point) {
  return distance_to(footprint, point) == 0;
}

double distance_to(const Footprint& footprint, Vec2 point) {
  const Vec2 seen = glm::abs(seen_from(footprint, point)) - 0.5 * footprint.size;
  return glm::length(glm::max(seen, Vec2{}));
}

double distance_to_edge(const Footprint& footprint, Vec2 direction) {
  const Vec2 along = glm::abs(seen_from({{}, footprint.heading, {}}, direction));
  const auto edge = [](double half, double share) {
    return share > 0 ? half / share : std::numeric_limits<double>::infinity();
  };
  return std::min(edge(footprint.size.x / 2, along.x), edge(footprint.size.y / 2, along.y));
}

double overlap_of(const Footprint& a, const Footprint& b) {
  const std::array<Vec2, 4> corners_a = corners_of(a), corners_b = corners_of(b);
  double least = std::numeric_limits<double>::max();
  for (const double heading : {a.heading, b.heading}) {
    const Vec2 front{std::cos(heading), std::sin(heading)};
    least = std::min({least, overlap_along(front, corners_a, corners_b),
                      overlap_along(left_of(front), corners_a, corners_b)});
  }
  return std::max(0.0, least);
}

FloorPlan with_obstacles(const FloorPlan& plan, std::span<const Footprint> footprints) {
  if (footprints.empty()) return plan;
  std::vector<OverlayRing> rings;
  for (const Ring& ring : plan.ring)
    rings.push_back({.vertex = {plan.vertex.begin() + ring.first,
                                plan.vertex.begin() + ring.first + ring.count}});
  for (const Footprint& footprint : footprints) {
    std::array<Vec2, 4> corners = corners_of(footprint);
    std::ranges::reverse(corners);  // the floor lies on the left of a wall, and this is none
    rings.push_back({.vertex = {corners.begin(), corners.end()}});
  }
  FloorPlan furnished = plan_of_walls(std::move(rings));
  furnished.name = plan.name;
  furnished.ordinal = plan.ordinal;
  furnished.height = plan.height;
  furnished.short_name = plan.short_name;
  furnished.doors = plan.doors;
  return furnished;
}

}  // namespace docent::floor
