#include "content/object/surface.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace docent::object {
namespace {

float square(Vec3 v) noexcept {
  return glm::dot(v, v);
}

/// Of a place from a line, where it is known that its foot lies between the ends.
float from_line(Vec3 away, Vec3 along, float share, float all) noexcept {
  return square(away - along * (all > 0 ? share / all : 0));
}

/// Of a place from a box.
inline float from_box(Vec3 low, Vec3 high, Vec3 place) noexcept {
  const auto outside = [](float below, float above) {
    return std::max(std::max(below, above), 0.0F);  // of three at once, gcc makes jumps
  };
  const float x = outside(low.x - place.x, place.x - high.x);
  const float y = outside(low.y - place.y, place.y - high.y);
  const float z = outside(low.z - place.z, place.z - high.z);
  return x * x + y * y + z * z;
}

constexpr float endless = std::numeric_limits<float>::max();
constexpr Box no_box{.low = Vec3{endless}, .high = Vec3{-endless}};

void add(Box& box, Vec3 place) noexcept {
  box.low = glm::min(box.low, place);
  box.high = glm::max(box.high, place);
}

/// Three times its middle.
Vec3 sum(const Corners& triangle) noexcept {
  return triangle[0] + triangle[1] + triangle[2];
}

}  // namespace

// Ericson 2005, Real-Time Collision Detection, 5.1.5.
float squared_distance(Vec3 place, const Corners& triangle) noexcept {
  const auto& [a, b, c] = triangle;
  const Vec3 ab = b - a, ac = c - a, from_a = place - a, from_b = place - b, from_c = place - c;
  const float d1 = glm::dot(ab, from_a), d2 = glm::dot(ac, from_a);
  if (d1 <= 0 && d2 <= 0) return square(from_a);
  const float d3 = glm::dot(ab, from_b), d4 = glm::dot(ac, from_b);
  if (d3 >= 0 && d4 <= d3) return square(from_b);
  const float w = d1 * d4 - d3 * d2;
  if (w <= 0 && d1 >= 0 && d3 <= 0) return from_line(from_a, ab, d1, d1 - d3);
  const float d5 = glm::dot(ab, from_c), d6 = glm::dot(ac, from_c);
  if (d6 >= 0 && d5 <= d6) return square(from_c);
  const float v = d5 * d2 - d1 * d6;
  if (v <= 0 && d2 >= 0 && d6 <= 0) return from_line(from_a, ac, d2, d2 - d6);
  const float u = d3 * d6 - d5 * d4;
  if (u <= 0 && d4 >= d3 && d5 >= d6)
    return from_line(from_b, c - b, d4 - d3, (d4 - d3) + (d5 - d6));
  const float all = u + v + w;
  if (!(all > 0)) return std::min({square(from_a), square(from_b), square(from_c)});
  return square(from_a - ab * (v / all) - ac * (w / all));
}

Surface::Surface(std::vector<Corners> triangles) : triangles_(std::move(triangles)) {
  nodes_.reserve(triangles_.size());
  nodes_.emplace_back();
  split(0, 0, static_cast<std::uint32_t>(triangles_.size()));
}

void Surface::split(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
  constexpr std::uint32_t few = 4;
  Box corners = no_box, middles = no_box;
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const Vec3& corner : triangles_[i]) add(corners, corner);
    add(middles, sum(triangles_[i]));
  }
  nodes_[node].low = corners.low;
  nodes_[node].high = corners.high;
  if (end - begin <= few) {
    nodes_[node].first = begin;
    nodes_[node].count = end - begin;
    return;
  }
  const Vec3 size = middles.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::uint32_t i) { return triangles_.begin() + i; };
  std::nth_element(at(begin), at(middle), at(end), [axis](const Corners& one, const Corners& two) {
    return sum(one)[axis] < sum(two)[axis];
  });
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = first;
  nodes_.resize(nodes_.size() + 2);
  split(first, begin, middle);
  split(first + 1, middle, end);
}

float Surface::squared_distance_from(Vec3 place, float enough, float most) noexcept {
  most = std::min(most, squared_distance(place, triangles_[last_]));
  struct Ahead {
    std::uint32_t node;
    float distance;
  };
  std::array<Ahead, 64> ahead;  // halves of halves: 32 deep at most, one of each
  std::size_t count = 0;
  std::uint32_t at = 0;
  while (most > enough) {
    const Node& node = nodes_[at];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      if (const float own = squared_distance(place, triangles_[i]); own < most) {
        most = own;
        last_ = i;
      }
    if (node.count == 0) {
      const auto ahead_at = [&](std::uint32_t n) {
        return Ahead{n, from_box(nodes_[n].low, nodes_[n].high, place)};
      };
      Ahead near = ahead_at(node.first), far = ahead_at(node.first + 1);
      if (far.distance < near.distance) std::swap(near, far);
      if (far.distance < most) ahead[count++] = far;
      if (near.distance < most) {
        at = near.node;
        continue;
      }
    }
    while (count > 0 && ahead[count - 1].distance >= most) --count;
    if (count == 0) break;
    at = ahead[--count].node;
  }
  return most;
}

}  // namespace docent::object
