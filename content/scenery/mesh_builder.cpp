#include "content/scenery/mesh_builder.h"

#include <algorithm>
#include <cmath>

namespace docent::scenery {
namespace {

Vec3 unit(Vec3 v) {
  const float length = std::sqrt(glm::dot(v, v));
  return length > 0 ? v / length : Vec3{0, 1, 0};
}

Vec2 unit(Vec2 v) {
  const double length = std::hypot(v.x, v.y);
  return length > 0 ? v / length : Vec2{1, 0};
}

Vec3 level(Vec2 direction) {
  return to_world(direction);
}

/// The outline with its sides cut into pieces of at most `longest` metres.
Outline with_short_sides(const Outline& outline, double longest) {
  Outline out;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 side = outline[(i + 1) % outline.size()] - outline[i];
    const auto pieces = static_cast<int>(std::ceil(std::hypot(side.x, side.y) / longest));
    for (int k = 0; k < std::max(1, pieces); ++k)
      out.push_back(outline[i] + side * (static_cast<double>(k) / std::max(1, pieces)));
  }
  return out;
}

}  // namespace

void MeshBuilder::use(Surface surface, std::int32_t exhibit) {
  indices_ = &parts_[{surface, exhibit}];
  sky_ = 255;
}

std::uint32_t MeshBuilder::vertex(Vec3 position, Vec3 normal, std::array<float, 2> uv) {
  vertices_.push_back({position, normal, uv, sky_, 255});
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

void MeshBuilder::quad(const std::array<Vec3, 4>& corners,
                       const std::array<std::array<float, 2>, 4>& uv) {
  const Vec3 normal = unit(glm::cross(corners[2] - corners[0], corners[3] - corners[1]));
  std::array<std::uint32_t, 4> index{};
  for (std::size_t i = 0; i < 4; ++i) index[i] = vertex(corners[i], normal, uv[i]);
  for (const std::size_t i : {0UL, 1UL, 2UL, 0UL, 2UL, 3UL}) indices_->push_back(index[i]);
}

void MeshBuilder::triangle(const std::array<Vec3, 3>& corners, Vec3 normal) {
  for (const Vec3& corner : corners) indices_->push_back(vertex(corner, normal));
}

void MeshBuilder::wall(Vec2 a, Vec2 b, std::span<const double> heights) {
  const Vec3 normal = level(-left_of(unit(b - a)));
  std::uint32_t below_a = vertex(to_world(a, heights[0]), normal);
  std::uint32_t below_b = vertex(to_world(b, heights[0]), normal);
  for (const double height : heights.subspan(1)) {
    const std::uint32_t above_a = vertex(to_world(a, height), normal);
    const std::uint32_t above_b = vertex(to_world(b, height), normal);
    indices_->insert(indices_->end(), {below_a, below_b, above_b, below_a, above_b, above_a});
    below_a = above_a;
    below_b = above_b;
  }
}

void MeshBuilder::sides(const Outline& outline, std::span<const double> heights, bool smooth) {
  const std::size_t n = outline.size();
  if (!smooth) {
    for (std::size_t i = 0; i < n; ++i) wall(outline[i], outline[(i + 1) % n], heights);
    return;
  }
  std::vector<std::uint32_t> below;
  for (const double height : heights) {
    std::vector<std::uint32_t> row;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 along = unit(outline[(i + 1) % n] - outline[(i + n - 1) % n]);
      row.push_back(vertex(to_world(outline[i], height), level(-left_of(along))));
    }
    for (std::size_t i = 0; !below.empty() && i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      indices_->insert(indices_->end(), {below[i], below[j], row[j], below[i], row[j], row[i]});
    }
    below = std::move(row);
  }
}

void MeshBuilder::slope(const Outline& low, double low_height, const Outline& high,
                        double high_height) {
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t j = (i + 1) % low.size();
    quad({to_world(low[i], low_height), to_world(low[j], low_height),
          to_world(high[j], high_height), to_world(high[i], high_height)});
  }
}

void MeshBuilder::lid(const Outline& convex, double height) {
  // Light is kept at vertices, so a lid has one about every hand's breadth.
  constexpr double spacing = 0.13;
  const Outline outline = with_short_sides(convex, spacing);
  const std::size_t n = outline.size();
  Vec2 centre{};
  for (const Vec2 p : outline) centre += p / static_cast<double>(n);
  double reach = 0;
  for (const Vec2 p : outline) reach = std::max(reach, std::hypot(p.x - centre.x, p.y - centre.y));
  const int rings = std::clamp(static_cast<int>(reach / spacing), 2, 12);

  const Vec3 up{0, 1, 0};
  std::vector<std::uint32_t> outer;
  for (int r = 0; r < rings; ++r) {
    const double share = 1 - static_cast<double>(r) / rings;
    std::vector<std::uint32_t> ring;
    for (const Vec2 p : outline)
      ring.push_back(vertex(to_world(centre + (p - centre) * share, height), up));
    for (std::size_t i = 0; !outer.empty() && i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      indices_->insert(indices_->end(), {outer[i], outer[j], ring[j], outer[i], ring[j], ring[i]});
    }
    outer = std::move(ring);
  }
  const std::uint32_t middle = vertex(to_world(centre, height), up);
  for (std::size_t i = 0; i < n; ++i)
    indices_->insert(indices_->end(), {outer[i], outer[(i + 1) % n], middle});
}

Scenery MeshBuilder::finish() && {
  Scenery scenery;
  scenery.vertices = std::move(vertices_);
  for (const auto& [key, indices] : parts_) {
    if (indices.empty()) continue;
    const auto first = static_cast<std::uint32_t>(scenery.indices.size());
    scenery.parts.push_back(
        {key.first, key.second, first, static_cast<std::uint32_t>(indices.size())});
    scenery.indices.insert(scenery.indices.end(), indices.begin(), indices.end());
  }
  return scenery;
}

Outline inset(const Outline& outline, double distance) {
  Outline out;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = left_of(unit(outline[i] - outline[(i + n - 1) % n]));
    const Vec2 on = left_of(unit(outline[(i + 1) % n] - outline[i]));
    out.push_back(outline[i] + (in + on) * (distance / std::max(0.3, 1 + dot(in, on))));
  }
  return out;
}

Outline rectangle(Vec2 centre, double heading, Vec2 half) {
  const Vec2 along{std::cos(heading), std::sin(heading)};
  const Vec2 across = left_of(along);
  return {centre - along * half.y + across * half.x, centre - along * half.y - across * half.x,
          centre + along * half.y - across * half.x, centre + along * half.y + across * half.x};
}

}  // namespace docent::scenery
