#include "content/draw/plan/plan_rings.h"

#include <algorithm>
#include <span>

#include "runtime/model/geometry/polygon.h"

namespace docent::draw {
namespace {

constexpr double longest_case = 6;     ///< Metres, the longer side of its box.
constexpr double thickest_wall = 1.2;  ///< Metres, of castles too.

std::span<const Vec2> corners_of(const FloorPlan& plan, const Ring& ring) {
  return std::span(plan.vertex).subspan(ring.first, ring.count);
}

/// The longer side of a ring's bounding box.
double extent(std::span<const Vec2> corners) {
  Vec2 low = corners.front(), high = low;
  for (const Vec2 corner : corners) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  return std::max(high.x - low.x, high.y - low.y);
}

/// Twice the area for each metre of edge: of a long wall, and of several that meet, their
/// thickness.
double thickness_of(std::span<const Vec2> corners) {
  double edge = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    edge += glm::distance(corners[i], corners[(i + 1) % corners.size()]);
  return edge > 0 ? 2 * std::abs(signed_area(corners)) / edge : 0;
}

}  // namespace

RingRole role_of(const FloorPlan& plan, const Ring& ring) {
  const std::span<const Vec2> corners = corners_of(plan, ring);
  if (corners.empty() || signed_area(corners) > 0) return RingRole::Outline;
  if (extent(corners) <= longest_case) return RingRole::Case;
  return thickness_of(corners) <= thickest_wall ? RingRole::Partition : RingRole::Block;
}

bool has_role(const FloorPlan& plan, RingRole role) {
  return std::ranges::any_of(plan.ring,
                             [&](const Ring& ring) { return role_of(plan, ring) == role; });
}

}  // namespace docent::draw
