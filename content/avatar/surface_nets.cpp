#include "content/avatar/surface_nets.h"

#include <array>

namespace docent::avatar {
namespace {

constexpr std::uint32_t no_vertex = 0xFFFFFFFF;

/// Corner c of a cell lies at ((c & 1), (c >> 1) & 1, c >> 2).
struct Grid {
  Vec3 low;
  float cell;
  std::array<std::uint32_t, 3> nodes;

  std::size_t index(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    return (static_cast<std::size_t>(z) * nodes[1] + y) * nodes[0] + x;
  }
  std::size_t stride(std::size_t axis) const {
    return axis == 0 ? 1 : axis == 1 ? nodes[0] : static_cast<std::size_t>(nodes[0]) * nodes[1];
  }
  Vec3 place(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    return low + cell * Vec3{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
  }
};

template <typename Visit>
void for_each_node(const Grid& grid, std::uint32_t margin, const Visit& visit) {
  for (std::uint32_t z = margin; z < grid.nodes[2] - margin; ++z)
    for (std::uint32_t y = margin; y < grid.nodes[1] - margin; ++y)
      for (std::uint32_t x = margin; x < grid.nodes[0] - margin; ++x) visit(x, y, z);
}

Grid grid_over(const Box3& box, float cell) {
  Grid grid{.low = box.low - 1.5F * cell, .cell = cell, .nodes = {}};
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<glm::length_t>(axis);
    grid.nodes[axis] = static_cast<std::uint32_t>((box.high[a] - box.low[a]) / cell) + 5;
  }
  return grid;
}

/// The field at every node near the surface. Far from it, where a whole block of cells lies on one
/// side, only the sign matters and the block's middle speaks for all of it.
std::vector<float> sampled(const DistanceField& field, const Grid& grid) {
  constexpr std::uint32_t block = 5;
  // From the middle of a block to its corners, and half as much again since a field is not quite a
  // distance.
  const float reach = 1.5F * 0.866F * static_cast<float>(block) * grid.cell;
  std::vector<float> value(grid.stride(2) * grid.nodes[2]);
  std::array<std::uint32_t, 3> b{};
  for (b[2] = 0; b[2] < grid.nodes[2]; b[2] += block)
    for (b[1] = 0; b[1] < grid.nodes[1]; b[1] += block)
      for (b[0] = 0; b[0] < grid.nodes[0]; b[0] += block) {
        const float middle = field(grid.place(b[0], b[1], b[2]) + 0.5F * (block - 1) * grid.cell);
        for (std::uint32_t z = b[2]; z < std::min(b[2] + block, grid.nodes[2]); ++z)
          for (std::uint32_t y = b[1]; y < std::min(b[1] + block, grid.nodes[1]); ++y)
            for (std::uint32_t x = b[0]; x < std::min(b[0] + block, grid.nodes[0]); ++x)
              value[grid.index(x, y, z)] =
                  std::abs(middle) > reach ? middle : field(grid.place(x, y, z));
      }
  return value;
}

/// Mean of the points where the surface crosses the edges of a cell; false when it crosses none.
bool mean_crossing(const Grid& grid, const std::vector<float>& value, std::uint32_t x,
                   std::uint32_t y, std::uint32_t z, Vec3& mean) {
  std::array<float, 8> corner{};
  const std::size_t first = grid.index(x, y, z);
  unsigned inside = 0;
  for (unsigned c = 0; c < 8; ++c) {
    corner[c] = value[first + (c & 1U) * grid.stride(0) + ((c >> 1U) & 1U) * grid.stride(1) +
                      (c >> 2U) * grid.stride(2)];
    inside += corner[c] < 0 ? 1 : 0;
  }
  if (inside == 0 || inside == 8) return false;
  Vec3 sum{0};
  float crossings = 0;
  for (unsigned c = 0; c < 8; ++c)
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned d = c | (1U << axis);
      if (d == c || (corner[c] < 0) == (corner[d] < 0)) continue;
      Vec3 at{static_cast<float>(c & 1U), static_cast<float>((c >> 1U) & 1U),
              static_cast<float>(c >> 2U)};
      at[static_cast<glm::length_t>(axis)] = corner[c] / (corner[c] - corner[d]);
      sum += at;
      crossings += 1;
    }
  mean = grid.place(x, y, z) + grid.cell * sum / crossings;
  return true;
}

/// A few Newton steps along the gradient where they begin, never further than a cell.
Vec3 pulled_onto(const DistanceField& field, Vec3 p, float cell) {
  const Vec3 start = p;
  float off = field(p);
  if (std::abs(off) < 0.004F * cell) return p;
  const float h = 0.2F * cell;
  const Vec3 slope{field(p + Vec3{h, 0, 0}) - field(p - Vec3{h, 0, 0}),
                   field(p + Vec3{0, h, 0}) - field(p - Vec3{0, h, 0}),
                   field(p + Vec3{0, 0, h}) - field(p - Vec3{0, 0, h})};
  const Vec3 gradient = slope / (2 * h);
  const Vec3 stride = gradient / std::max(glm::dot(gradient, gradient), 0.1F);
  for (int step = 0; step < 6 && std::abs(off) >= 0.004F * cell; ++step) {
    p = glm::clamp(p - off * stride, start - 0.5F * cell, start + 0.5F * cell);
    off = field(p);
  }
  return p;
}

}  // namespace

Vec3 gradient_of(const DistanceField& field, Vec3 p, float step) {
  const Vec3 slope{field(p + Vec3{step, 0, 0}) - field(p - Vec3{step, 0, 0}),
                   field(p + Vec3{0, step, 0}) - field(p - Vec3{0, step, 0}),
                   field(p + Vec3{0, 0, step}) - field(p - Vec3{0, 0, step})};
  const float size = glm::length(slope);
  return size > 1e-12F ? slope / size : Vec3{0, 1, 0};
}

TriangleSurface polygonise(const DistanceField& field, const Box3& box, float cell) {
  const Grid grid = grid_over(box, cell);
  const std::size_t count = grid.stride(2) * grid.nodes[2];
  const std::vector<float> value = sampled(field, grid);

  TriangleSurface surface;
  std::vector<std::uint32_t> vertex(count, no_vertex);
  for (std::uint32_t z = 0; z + 1 < grid.nodes[2]; ++z)
    for (std::uint32_t y = 0; y + 1 < grid.nodes[1]; ++y)
      for (std::uint32_t x = 0; x + 1 < grid.nodes[0]; ++x) {
        Vec3 mean{};
        if (!mean_crossing(grid, value, x, y, z, mean)) continue;
        const Vec3 p = pulled_onto(field, mean, cell);
        vertex[grid.index(x, y, z)] = static_cast<std::uint32_t>(surface.position.size());
        surface.position.push_back(p);
      }

  // Every grid edge that crosses the surface is ringed by four cells: two triangles.
  for_each_node(grid, 1, [&](auto x, auto y, auto z) {
    const std::size_t here = grid.index(x, y, z);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool inside = value[here] < 0;
      if (inside == (value[here + grid.stride(axis)] < 0)) continue;
      const std::size_t u = grid.stride((axis + 1) % 3);
      const std::size_t v = grid.stride((axis + 2) % 3);
      std::array<std::uint32_t, 4> ring{vertex[here], vertex[here - u], vertex[here - u - v],
                                        vertex[here - v]};
      if (!inside) std::swap(ring[1], ring[3]);
      // The shorter diagonal makes the rounder pair of triangles.
      const auto gap = [&](std::size_t a, std::size_t b) {
        return glm::length(surface.position[ring[a]] - surface.position[ring[b]]);
      };
      const std::size_t s = gap(0, 2) <= gap(1, 3) ? 0 : 1;
      for (const std::size_t corner : {s, s + 1, s + 2, s, s + 2, s + 3})
        surface.indices.push_back(ring[corner % 4]);
    }
  });
  return surface;
}

}  // namespace docent::avatar
