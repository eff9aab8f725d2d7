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

/// For each vertex of the triangles the one that stands for it.
std::vector<std::uint32_t> clustered(const SkinnedMesh& mesh,
                                     std::span<const std::uint32_t> indices, float side) {
  std::vector<std::uint32_t> stands_for(mesh.vertices.size());
  std::vector<std::uint8_t> is_taken(mesh.vertices.size());  // some six triangles share a vertex
  std::vector<std::pair<Cell, std::uint32_t>> sorted;
  sorted.reserve(std::min(indices.size(), mesh.vertices.size()));
  for (const std::uint32_t v : indices)
    if (std::exchange(is_taken[v], std::uint8_t{1}) == 0)
      sorted.emplace_back(cell_of(mesh.vertices[v], side), v);
  std::ranges::sort(sorted);

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
  return coarser(mesh, mesh.indices, cell);
}

std::vector<std::uint32_t> coarser(const SkinnedMesh& mesh, std::span<const std::uint32_t> indices,
                                   float cell) {
  const std::vector<std::uint32_t> stands_for = clustered(mesh, indices, cell);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
    std::array<std::uint32_t, 3> t{};
    for (std::size_t corner = 0; corner < 3; ++corner) t[corner] = stands_for[indices[k + corner]];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    std::ranges::rotate(t, std::ranges::min_element(t));
    triangles.push_back(t);
  }
  // Neighbours in the list share vertices, and a triangle is there once.
  std::ranges::sort(triangles);
  const auto twice = std::ranges::unique(triangles);
  triangles.erase(twice.begin(), twice.end());

  std::vector<std::uint32_t> coarse;
  coarse.reserve(3 * triangles.size());
  for (const auto& t : triangles) coarse.insert(coarse.end(), t.begin(), t.end());
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
