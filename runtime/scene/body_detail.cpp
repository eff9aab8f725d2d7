#include "runtime/scene/body_detail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace docent::scene {
namespace {

constexpr float modelled_stature = 1.7F;  // metres, of coarse_levels

using Cell = std::array<std::int32_t, 4>;  // three of the grid, and the material

Cell cell_of(const SkinnedVertex& vertex, float side) noexcept {
  const Vec3 at = glm::floor(vertex.position / side);
  return {static_cast<std::int32_t>(at.x), static_cast<std::int32_t>(at.y),
          static_cast<std::int32_t>(at.z), static_cast<std::int32_t>(vertex.material)};
}

std::uint32_t nearest_to_middle(const SkinnedMesh& mesh,
                                std::span<const std::pair<Cell, std::uint32_t>> cluster) noexcept {
  Vec3 middle{};
  for (const auto& [cell, v] : cluster) middle += mesh.vertices[v].position;
  middle /= static_cast<float>(cluster.size());
  return std::ranges::min_element(cluster, {},
                                  [&](const auto& it) {
                                    const Vec3 off = mesh.vertices[it.second].position - middle;
                                    return glm::dot(off, off);
                                  })
      ->second;
}

/// For each vertex the one that stands for it.
std::vector<std::uint32_t> clustered(const SkinnedMesh& mesh, float side) {
  std::vector<std::pair<Cell, std::uint32_t>> sorted;
  sorted.reserve(mesh.vertices.size());
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
    sorted.emplace_back(cell_of(mesh.vertices[v], side), v);
  std::ranges::sort(sorted);

  std::vector<std::uint32_t> stands_for(mesh.vertices.size());
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last =
        std::find_if(first, sorted.end(), [&](const auto& it) { return it.first != first->first; });
    const std::uint32_t chosen = nearest_to_middle(mesh, {first, last});
    for (; first != last; ++first) stands_for[first->second] = chosen;
  }
  return stands_for;
}

}  // namespace

std::vector<std::uint32_t> coarser(const SkinnedMesh& mesh, float cell) {
  const std::vector<std::uint32_t> stands_for = clustered(mesh, cell);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
    std::array<std::uint32_t, 3> t{};
    for (std::size_t corner = 0; corner < 3; ++corner)
      t[corner] = stands_for[mesh.indices[k + corner]];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    std::ranges::rotate(t, std::ranges::min_element(t));
    triangles.push_back(t);
  }
  // Neighbours in the list share vertices, and a triangle is there once.
  std::ranges::sort(triangles);
  const auto twice = std::ranges::unique(triangles);
  triangles.erase(twice.begin(), twice.end());

  std::vector<std::uint32_t> indices;
  indices.reserve(3 * triangles.size());
  for (const auto& t : triangles) indices.insert(indices.end(), t.begin(), t.end());
  return indices;
}

float stature_of(const SkinnedMesh& mesh) noexcept {
  float stature = 0.01F;
  for (const SkinnedVertex& vertex : mesh.vertices) stature = std::max(stature, vertex.position.y);
  return stature;
}

BodyLevels levels_of(const SkinnedMesh& mesh) {
  BodyLevels levels;
  const auto add = [&](std::size_t level, const std::vector<std::uint32_t>& indices) {
    levels.run[level] = {static_cast<std::uint32_t>(levels.indices.size()),
                         static_cast<std::uint32_t>(indices.size())};
    levels.indices.insert(levels.indices.end(), indices.begin(), indices.end());
  };
  add(0, mesh.indices);
  const float scale = stature_of(mesh) / modelled_stature;
  for (std::size_t i = 0; i < coarse_levels.size(); ++i)
    add(i + 1, coarser(mesh, coarse_levels[i].cell * scale));
  return levels;
}

}  // namespace docent::scene
