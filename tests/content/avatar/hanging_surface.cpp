#include "tests/content/avatar/hanging_surface.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace docent::test {
namespace {

constexpr std::size_t rows = 120;
constexpr float rows_a_metre = 60;

/// Where a segment goes through a triangle, as a share of it; more than 1: nowhere.
float through(Vec3 from, Vec3 to, const std::array<Vec3, 3>& t) {
  const Vec3 along = to - from, a = t[1] - t[0], b = t[2] - t[0];
  const Vec3 p = glm::cross(along, b);
  const float det = glm::dot(a, p);
  if (std::abs(det) < 1e-12F) return 2;
  const Vec3 off = from - t[0];
  const float u = glm::dot(off, p) / det;
  const Vec3 q = glm::cross(off, a);
  const float v = glm::dot(along, q) / det;
  const float share = glm::dot(b, q) / det;
  return u < 0 || v < 0 || u + v > 1 || share < 0 ? 2 : share;
}

std::size_t row_of(float y) {
  return static_cast<std::size_t>(std::clamp(y * rows_a_metre, 0.0F, static_cast<float>(rows - 1)));
}

}  // namespace

HangingSurface::HangingSurface(const SkinnedMesh& mesh,
                               const std::function<bool(const SkinnedVertex&)>& is_part_of_it)
    : mesh_{mesh} {
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const auto corners = std::span(mesh.indices).subspan(t, 3);
    if (std::ranges::all_of(corners,
                            [&](std::uint32_t v) { return is_part_of_it(mesh.vertices[v]); }))
      indices_.push_back({corners[0], corners[1], corners[2]});
  }
}

void HangingSurface::hang(const PosedBody& body) {
  for (auto& row : row_) row.clear();
  for (const auto& corners : indices_) {
    std::array<Vec3, 3> t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = body.place_of(mesh_.vertices[corners[k]]);
    const auto [low, high] = std::minmax({t[0].y, t[1].y, t[2].y});
    for (std::size_t row = row_of(low); row <= row_of(high); ++row) row_[row].push_back(t);
  }
}

float HangingSurface::first_on(Vec3 from, Vec3 to) const {
  float first = 2;
  const auto [low, high] = std::minmax({from.y, to.y});
  for (std::size_t row = row_of(low); row <= row_of(high); ++row)
    for (const auto& triangle : row_[row]) first = std::min(first, through(from, to, triangle));
  return first;
}

float depth_outside(const std::vector<CoveredPlace>& places, const PosedBody& body,
                    const HangingSurface& surface) {
  float furthest = 0;
  for (const CoveredPlace& place : places) {
    const Vec3 from = body.place_of(place.axis), to = body.place_of(place.skin);
    const float first = surface.first_on(from, to);
    if (first <= 1) furthest = std::max(furthest, (1 - first) * glm::length(to - from));
  }
  return furthest;
}

}  // namespace docent::test
