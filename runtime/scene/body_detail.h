#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/model/motion/skinned_mesh.h"

namespace docent::scene {

/// Triangles of a coarser body on the same vertices: those of one material within a cube of `cell`
/// metres become one, the vertex nearest to their middle (Rossignac and Borrel 1993). Triangles
/// that thereby lose their area are left out. Edges move by less than a cell's diagonal, so a body
/// whose pixels are larger than that looks the same. The same mesh gives the same triangles.
std::vector<std::uint32_t> coarser(const SkinnedMesh& mesh, float cell);
/// Likewise, of one run of the mesh's indices and the vertices that it uses.
std::vector<std::uint32_t> coarser(const SkinnedMesh& mesh, std::span<const std::uint32_t> indices,
                                   float cell);

/// Below this height on the screen, in pixels, a body is drawn from cells of this size, in metres
/// of a body of 1.7 m: about two pixels.
struct Coarseness {
  float height, cell;
};
inline constexpr std::array<Coarseness, 4> coarse_levels{
    {{260, 0.017F}, {150, 0.030F}, {75, 0.050F}, {45, 0.075F}}};

/// Height of a body's highest vertex, in metres; a little where there is none.
float stature_of(const SkinnedMesh& mesh) noexcept;

/// The triangles of a mesh's bodies in all levels of detail, the finest first, all on its own
/// vertices.
struct BodyLevels {
  static constexpr std::size_t count = 1 + coarse_levels.size();
  /// A level's part of the indices.
  struct Run {
    std::uint32_t first = 0, size = 0;
  };
  std::vector<std::uint32_t> indices;
  using Levels = std::array<Run, count>;
  std::vector<Levels> figure;  ///< One a body.
};
/// Takes tens of milliseconds.
BodyLevels levels_of(const SkinnedMesh& mesh);

}  // namespace docent::scene
