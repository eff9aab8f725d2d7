#include "content/import/drawing/inscribed.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "runtime/model/geometry/polygon.h"
#include "runtime/model/geometry/segment.h"

namespace docent::import {
namespace {

constexpr double precision = 0.02;
constexpr int most_tries = 2000;

/// Positive inside.
double depth(std::span<const std::vector<Vec2>> rings, Vec2 p) {
  double nearest = 1e300;
  for (const std::vector<Vec2>& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      nearest = std::min(
          nearest, nearest_on_segment(p, ring[i], ring[(i + 1) % ring.size()]).distance_squared);
  return (inside(rings, p) ? 1 : -1) * std::sqrt(nearest);
}

struct Cell {
  Vec2 centre{};
  double half = 0, deep = 0;
  double bound() const { return deep + half * std::numbers::sqrt2; }
  bool operator<(const Cell& other) const { return bound() < other.bound(); }
};

}  // namespace

bool inside(std::span<const std::vector<Vec2>> rings, Vec2 p) {
  if (rings.empty() || !contains(rings.front(), p)) return false;
  return std::none_of(rings.begin() + 1, rings.end(),
                      [&](const std::vector<Vec2>& hole) { return contains(hole, p); });
}

/// Agafonkin's polylabel: cells that could hold a larger circle are quartered, best first.
InscribedCircle inscribed_circle(std::span<const std::vector<Vec2>> rings) {
  if (rings.empty() || rings.front().size() < 3) return {};
  Vec2 low = rings.front().front(), high = low;
  for (const Vec2 p : rings.front()) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double size = std::max({std::min(high.x - low.x, high.y - low.y),
                                std::max(high.x - low.x, high.y - low.y) / 64, 1e-3});
  std::priority_queue<Cell> queue;
  const auto cell_at = [&](Vec2 centre, double half) {
    return Cell{centre, half, depth(rings, centre)};
  };
  for (double x = low.x; x < high.x; x += size)
    for (double y = low.y; y < high.y; y += size)
      queue.push(cell_at(Vec2{x, y} + Vec2(size / 2), size / 2));
  InscribedCircle best;
  for (int tries = 0; !queue.empty() && tries < most_tries; ++tries) {
    const Cell cell = queue.top();
    queue.pop();
    if (cell.deep > best.radius) best = {cell.centre, cell.deep};
    if (cell.bound() - best.radius < precision) break;
    const double half = cell.half / 2;
    for (const Vec2 corner :
         {Vec2{-half, -half}, Vec2{half, -half}, Vec2{-half, half}, Vec2{half, half}})
      queue.push(cell_at(cell.centre + corner, half));
  }
  return best;
}

}  // namespace docent::import
