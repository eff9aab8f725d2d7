#include "runtime/model/geometry/treads.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/model/geometry/polygon.h"

namespace docent {
namespace {

constexpr double riser = 0.17;    // metres that a step is high, or a little less
constexpr double landing = 0.35;  // metres before and behind treads that nothing is drawn of

int count_of(double rise) noexcept {
  return std::max(1, static_cast<int>(std::ceil(std::abs(rise) / riser - 1e-9)));
}

bool is_convex(std::span<const Vec2> outline) noexcept {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i];
    const Vec2 b = outline[(i + 1) % outline.size()];
    const Vec2 c = outline[(i + 2) % outline.size()];
    if (cross(b - a, c - b) < -1e-9) return false;
  }
  return outline.size() >= 3;
}

}  // namespace

double Treads::height_at(double distance) const noexcept {
  if (distance < near) return 0;
  if (distance >= near + length) return rise;
  return height_of(std::clamp(static_cast<int>((distance - near) / depth()), 0, count - 1));
}

Treads treads_within(std::span<const Vec2> outline, Vec2 here, Vec2 there, double rise) noexcept {
  const Vec2 along = (there - here) / glm::distance(here, there);
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const Vec2 corner : outline) {
    low = std::min(low, dot(corner - here, along));
    high = std::max(high, dot(corner - here, along));
  }
  return {.near = low, .length = high - low, .rise = rise, .count = count_of(rise)};
}

Treads treads_between(Vec2 here, Vec2 there, double rise) noexcept {
  const double way = glm::distance(here, there);
  const double before = std::min(landing, way / 4);
  return {.near = before, .length = way - 2 * before, .rise = rise, .count = count_of(rise)};
}

std::optional<Hole> hole_between(const FloorPlan& plan, Vec2 here, Vec2 there) {
  for (std::size_t r = 0; r < plan.ring.size(); ++r) {
    const auto first = plan.vertex.begin() + plan.ring[r].first;
    Hole hole{r, std::vector<Vec2>(first, first + plan.ring[r].count)};
    if (signed_area(hole.outline) >= 0) continue;
    std::ranges::reverse(hole.outline);
    if (contains(hole.outline, (here + there) / 2.0) && is_convex(hole.outline)) return hole;
  }
  return {};
}

}  // namespace docent
