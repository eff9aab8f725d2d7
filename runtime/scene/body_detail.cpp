#include "runtime/scene/body_detail.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>

#include "runtime/model/none.h"

namespace docent::scene {
namespace {

constexpr float modelled_stature = 1.7F;  // metres, of coarse_levels

using Cell = std::array<std::int32_t, 4>;  // three of the grid, and the material

Cell cell_of(const SkinnedVertex& vertex, float side) noexcept {
  const Vec3 at = glm::floor(vertex.position / side);
  return {static_cast<std::int32_t>(at.x), static_cast<std::int32_t>(at.y),
          static_cast<std::int32_t>(at.z), static_cast<std::int32_t>(vertex.material)};
}

std::size_t hash_of(const Cell& cell) noexcept {
  std::uint64_t hash = 0;
  for (const std::int32_t part : cell)
    hash = (hash ^ static_cast<std::uint32_t>(part)) * 0x9E3779B97F4A7C15ULL;
  return static_cast<std::size_t>(hash >> 32U);
}

/// The vertices in one cell.
struct Cluster {
  Cell cell;
  Vec3 sum{};
  float count = 0;
  float nearest = std::numeric_limits<float>::max();  ///< Squared, from the chosen to the middle.
  std::uint32_t chosen = 0;                           ///< The one that stands for all.
};

/// Clusters by cell, in an open table.
class ClusterTable {
 public:
  explicit ClusterTable(std::size_t most) : slot_(std::bit_ceil(2 * most + 1), none) {
    cluster_.reserve(most);
  }
  std::uint32_t find_or_add(const Cell& cell) {
    std::size_t i = hash_of(cell) & (slot_.size() - 1);
    for (; slot_[i] != none; i = (i + 1) & (slot_.size() - 1))
      if (cluster_[slot_[i]].cell == cell) return slot_[i];
    slot_[i] = static_cast<std::uint32_t>(cluster_.size());
    cluster_.push_back({.cell = cell});
    return slot_[i];
  }
  Cluster& operator[](std::uint32_t cluster) noexcept { return cluster_[cluster]; }

 private:
  std::vector<std::uint32_t> slot_;
  std::vector<Cluster> cluster_;
};

/// Each vertex of the triangles once, in ascending order.
std::vector<std::uint32_t> vertices_of(std::span<const std::uint32_t> indices) {
  if (indices.empty()) return {};
  const auto [least, most] = std::ranges::minmax(indices);
  std::vector<std::uint8_t> is_used(most - least + 1);
  for (const std::uint32_t v : indices) is_used[v - least] = 1;
  std::vector<std::uint32_t> used;
  for (std::uint32_t v = least; v <= most; ++v)
    if (is_used[v - least] != 0) used.push_back(v);
  return used;
}

/// For each vertex of the triangles the one that stands for it.
std::vector<std::uint32_t> clustered(const SkinnedMesh& mesh,
                                     std::span<const std::uint32_t> indices, float side) {
  const std::vector<std::uint32_t> used = vertices_of(indices);
  ClusterTable clusters(used.size());
  std::vector<std::uint32_t> cluster_of;
  cluster_of.reserve(used.size());
  for (const std::uint32_t v : used) {
    cluster_of.push_back(clusters.find_or_add(cell_of(mesh.vertices[v], side)));
    clusters[cluster_of.back()].sum += mesh.vertices[v].position;
    clusters[cluster_of.back()].count += 1;
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    Cluster& cluster = clusters[cluster_of[i]];
    const Vec3 off = mesh.vertices[used[i]].position - cluster.sum / cluster.count;
    if (const float square = glm::dot(off, off); square < cluster.nearest) {
      cluster.nearest = square;
      cluster.chosen = used[i];
    }
  }
  std::vector<std::uint32_t> stands_for(mesh.vertices.size());
  for (std::size_t i = 0; i < used.size(); ++i)
    stands_for[used[i]] = clusters[cluster_of[i]].chosen;
  return stands_for;
}

/// Its corners from the least on, so that the same triangle is the same.
struct Triangle {
  std::uint64_t first_two;
  std::uint32_t third;
  auto operator<=>(const Triangle&) const = default;
};

}  // namespace

std::vector<std::uint32_t> coarser(const SkinnedMesh& mesh, float cell) {
  return coarser(mesh, mesh.indices, cell);
}

std::vector<std::uint32_t> coarser(const SkinnedMesh& mesh, std::span<const std::uint32_t> indices,
                                   float cell) {
  const std::vector<std::uint32_t> stands_for = clustered(mesh, indices, cell);
  std::vector<Triangle> triangles;
  triangles.reserve(indices.size() / 3);
  for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
    std::uint32_t a = stands_for[indices[k]], b = stands_for[indices[k + 1]],
                  c = stands_for[indices[k + 2]];
    if (a == b || b == c || c == a) continue;
    while (a > b || a > c) std::tie(a, b, c) = std::tuple(b, c, a);
    triangles.push_back({std::uint64_t{a} << 32U | b, c});
  }
  // Neighbours in the list share vertices, and a triangle is there once.
  std::ranges::sort(triangles);
  const auto twice = std::ranges::unique(triangles);
  triangles.erase(twice.begin(), twice.end());

  std::vector<std::uint32_t> coarse;
  coarse.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    coarse.insert(coarse.end(), {static_cast<std::uint32_t>(t.first_two >> 32U),
                                 static_cast<std::uint32_t>(t.first_two), t.third});
  return coarse;
}

float stature_of(const SkinnedMesh& mesh) noexcept {
  float stature = 0.01F;
  for (const SkinnedVertex& vertex : mesh.vertices) stature = std::max(stature, vertex.position.y);
  return stature;
}

BodyLevels levels_of(const SkinnedMesh& mesh) {
  BodyLevels levels;
  const auto add = [&](std::span<const std::uint32_t> indices) {
    const BodyLevels::Run run{static_cast<std::uint32_t>(levels.indices.size()),
                              static_cast<std::uint32_t>(indices.size())};
    levels.indices.insert(levels.indices.end(), indices.begin(), indices.end());
    return run;
  };
  const float scale = stature_of(mesh) / modelled_stature;
  std::uint32_t begin = 0;
  for (const std::uint32_t end : mesh.figure_end) {
    const auto body = std::span(mesh.indices).subspan(begin, end - begin);
    BodyLevels::Levels& level = levels.figure.emplace_back();
    level[0] = add(body);
    for (std::size_t i = 0; i < coarse_levels.size(); ++i)
      level[i + 1] = add(coarser(mesh, body, coarse_levels[i].cell * scale));
    begin = end;
  }
  return levels;
}

}  // namespace docent::scene
