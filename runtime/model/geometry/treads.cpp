#include "runtime/model/geometry/treads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "runtime/model/geometry/polygon.h"

namespace docent {
namespace {

constexpr double highest_riser = 0.17;  // metres

std::vector<Vec2> outline_of(const FloorPlan& plan, const Ring& ring) {
  const auto first = plan.vertex.begin() + static_cast<std::ptrdiff_t>(ring.first);
  return {first, first + static_cast<std::ptrdiff_t>(ring.count)};
}

bool is_convex(const std::vector<Vec2>& outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i];
    const Vec2 b = outline[(i + 1) % outline.size()];
    const Vec2 c = outline[(i + 2) % outline.size()];
    if (cross(b - a, c - b) < -1e-9) return false;
  }
  return outline.size() >= 3;
}

}  // namespace

int steps_of(double rise) noexcept {
  return std::max(1, static_cast<int>(std::ceil(std::abs(rise) / highest_riser)));
}

std::optional<std::size_t> flight_hole(const FloorPlan& plan, Vec2 here, Vec2 there) {
  for (std::size_t r = 0; r < plan.ring.size(); ++r) {
    std::vector<Vec2> outline = outline_of(plan, plan.ring[r]);
    if (signed_area(outline) >= 0) continue;  // floor lies within
    std::ranges::reverse(outline);
    if (contains(outline, (here + there) / 2.0) && is_convex(outline)) return r;
  }
  return {};
}

Treads treads_between(const FloorPlan& plan, Vec2 here, Vec2 there, double rise) {
  Treads treads{.count = steps_of(rise)};
  treads.riser = rise / treads.count;
  double low = 0, high = glm::distance(here, there);
  const Vec2 along = (there - here) / high;
  if (const auto hole = flight_hole(plan, here, there)) {
    low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    for (const Vec2 corner : outline_of(plan, plan.ring[*hole])) {
      low = std::min(low, dot(corner - here, along));
      high = std::max(high, dot(corner - here, along));
    }
  }
  treads.near = low;
  treads.depth = (high - low) / treads.count;
  return treads;
}

}  // namespace docent
