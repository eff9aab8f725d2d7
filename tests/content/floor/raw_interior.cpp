#include "tests/content/floor/raw_interior.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/model/none.h"

namespace docent::test {
namespace {

double distance(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double length2 = dot(along, along);
  const double t = length2 > 0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * along);
}

}  // namespace

RawInterior::RawInterior(const import::ImportedPlan& plan) {
  low_ = {infinity, infinity}, high_ = -low_;
  for (const import::ImportedPolygon& polygon : plan.polygons) {
    std::vector<std::size_t>& own = rings_of_.emplace_back();
    own.push_back(rings_);
    add(polygon.outer);
    for (const import::ImportedRing& hole : polygon.holes) {
      own.push_back(rings_);
      add(hole);
    }
  }
}

void RawInterior::add(const import::ImportedRing& ring) {
  for (std::size_t i = 0; i < ring.vertex.size(); ++i) {
    sides_.push_back({ring.vertex[i], ring.vertex[(i + 1) % ring.vertex.size()], rings_});
    low_ = glm::min(low_, ring.vertex[i]);
    high_ = glm::max(high_, ring.vertex[i]);
  }
  ++rings_;
}

bool RawInterior::is_floor(const std::vector<int>& winding) const {
  return std::ranges::any_of(rings_of_, [&](const std::vector<std::size_t>& rings) {
    const auto is_round = [&](std::size_t ring) { return winding[ring] != 0; };
    return is_round(rings.front()) && std::none_of(rings.begin() + 1, rings.end(), is_round);
  });
}

std::vector<RawInterior::Crossing> RawInterior::crossings(double y) const {
  std::vector<Crossing> found;
  for (const Side& side : sides_)
    if ((side.a.y > y) != (side.b.y > y))
      found.push_back({side.a.x + (y - side.a.y) / (side.b.y - side.a.y) * (side.b.x - side.a.x),
                       side.ring, side.b.y > side.a.y ? 1 : -1});
  std::ranges::sort(found, {}, &Crossing::x);
  return found;
}

bool RawInterior::holds(Vec2 point) const {
  std::vector<int> winding(rings_, 0);
  for (const Crossing& crossing : crossings(point.y))
    if (crossing.x < point.x) winding[crossing.ring] += crossing.turn;
  return is_floor(winding);
}

double RawInterior::width_at(double y) const {
  std::vector<int> winding(rings_, 0);
  double width = 0, from = 0;
  for (const Crossing& crossing : crossings(y)) {
    if (is_floor(winding)) width += crossing.x - from;
    from = crossing.x;
    winding[crossing.ring] += crossing.turn;
  }
  return width;
}

std::vector<double> RawInterior::heights() const {
  std::vector<double> heights;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const auto& [a, b, ring] = sides_[i];
    heights.push_back(a.y);
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 c = sides_[j].a, along = b - a, other = sides_[j].b - c;
      const double area = cross(along, other);
      if (area == 0) continue;
      const double t = cross(c - a, other) / area;
      if (t > 0 && t < 1) heights.push_back(a.y + t * along.y);
    }
  }
  std::ranges::sort(heights);
  heights.erase(std::ranges::unique(heights).begin(), heights.end());
  return heights;
}

double RawInterior::area() const {
  double area = 0;
  const std::vector<double> all = heights();
  for (std::size_t i = 1; i < all.size(); ++i)
    area += (all[i] - all[i - 1]) * width_at(all[i - 1] + (all[i] - all[i - 1]) / 2);
  return area;
}

double RawInterior::distance_to_sides(Vec2 point) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Side& side : sides_) nearest = std::min(nearest, distance(point, side.a, side.b));
  return nearest;
}

double RawInterior::length() const {
  double length = 0;
  for (const Side& side : sides_) length += glm::distance(side.a, side.b);
  return length;
}

}  // namespace docent::test
