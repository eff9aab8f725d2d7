#include "content/object/occlusion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace docent::object {
namespace {

constexpr int sides = 48, side_pixels = 192;

/// Evenly over the sphere (a Fibonacci lattice), but for what comes from below the floor.
std::vector<Vec3> directions() {
  std::vector<Vec3> all;
  const float golden = std::numbers::pi_v<float> * (3 - std::sqrt(5.0F));
  for (int i = 0; i < sides; ++i) {
    constexpr float lowest = -0.15F;
    const float y = 1 - (1 - lowest) * (static_cast<float>(i) + 0.5F) / sides;
    const float r = std::sqrt(1 - y * y), turn = golden * static_cast<float>(i);
    all.emplace_back(r * std::cos(turn), y, r * std::sin(turn));
  }
  return all;
}

/// An object as it looks from one side: how near it is at each pixel.
class DepthPicture {
 public:
  DepthPicture(const Shape& shape, Vec3 from) : z_{from} {
    x_ = glm::normalize(glm::cross(std::abs(z_.y) < 0.9F ? Vec3{0, 1, 0} : Vec3{1, 0, 0}, z_));
    y_ = glm::cross(z_, x_);
    const Box box = box_of(shape);
    middle_ = (box.low + box.high) / 2.0F;
    reach_ = std::max(1e-6F, glm::length(box.size()) / 2);
    nearest_.assign(std::size_t{side_pixels} * side_pixels, std::numeric_limits<float>::lowest());
    for (const ShapeVertex& v : shape.vertices) seen_.push_back(seen(v.position));
    for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3)
      fill(seen_[shape.indices[k]], seen_[shape.indices[k + 1]], seen_[shape.indices[k + 2]]);
  }

  /// Does nothing stand before a place a little out of the surface?
  bool sees(Vec3 place) const {
    constexpr float bias = 0.03F;  // of the object's reach
    const Vec3 p = seen(place);
    return p.z + bias >= nearest_[at(bound(p.x), bound(p.y))];
  }

 private:
  static int bound(float pixel) { return std::clamp(static_cast<int>(pixel), 0, side_pixels - 1); }
  static std::size_t at(int x, int y) {
    return static_cast<std::size_t>(y) * side_pixels + static_cast<std::size_t>(x);
  }

  /// Pixels across and down, and shares of the reach towards the eye.
  Vec3 seen(Vec3 p) const {
    const Vec3 d = (p - middle_) / reach_;
    constexpr float half = side_pixels / 2.0F;
    return {half * (1 + glm::dot(d, x_)), half * (1 + glm::dot(d, y_)), glm::dot(d, z_)};
  }

  void fill(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto edge = [](const Vec3& p, const Vec3& q, float x, float y) {
      return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    };
    const float area = edge(a, b, c.x, c.y);
    if (area == 0) return;
    for (int y = bound(std::min({a.y, b.y, c.y})); y <= bound(std::max({a.y, b.y, c.y})); ++y)
      for (int x = bound(std::min({a.x, b.x, c.x})); x <= bound(std::max({a.x, b.x, c.x})); ++x) {
        const float px = static_cast<float>(x) + 0.5F, py = static_cast<float>(y) + 0.5F;
        const float u = edge(b, c, px, py) / area, v = edge(c, a, px, py) / area, w = 1 - u - v;
        if (u < 0 || v < 0 || w < 0) continue;
        float& depth = nearest_[at(x, y)];
        depth = std::max(depth, u * a.z + v * b.z + w * c.z);
      }
  }

  Vec3 x_{}, y_{}, z_{}, middle_{};
  float reach_ = 1;
  std::vector<float> nearest_;
  std::vector<Vec3> seen_;
};

}  // namespace

std::vector<std::uint8_t> occlusion_of(const Shape& shape, const std::vector<Vec3>& normals) {
  std::vector<float> open(shape.vertices.size()), all(shape.vertices.size());
  const float out = 0.02F * glm::length(box_of(shape).size());
  for (const Vec3& direction : directions()) {
    const DepthPicture picture(shape, direction);
    for (std::size_t v = 0; v < shape.vertices.size(); ++v) {
      const float share = glm::dot(normals[v], direction);
      if (share <= 0) continue;
      all[v] += share;
      if (picture.sees(shape.vertices[v].position + out * normals[v])) open[v] += share;
    }
  }
  std::vector<std::uint8_t> occlusion;
  for (std::size_t v = 0; v < open.size(); ++v)
    // What looks down sees the floor, which is bright where nothing stands on it.
    occlusion.push_back(static_cast<std::uint8_t>(
        std::lround(255 * (all[v] > 0 ? std::clamp(open[v] / all[v], 0.0F, 1.0F) : 0.5F))));
  return occlusion;
}

}  // namespace docent::object
