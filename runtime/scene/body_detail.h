#pragma once

#include <cstdint>
#include <vector>

#include "runtime/model/motion/skinned_mesh.h"

namespace docent::scene {

/// Triangles of a coarser body on the same vertices: those of one material within a cube of `cell`
/// metres become one, the vertex nearest to their middle (Rossignac and Borrel 1993). Triangles
/// that thereby lose their area are left out. Edges move by less than a cell's diagonal, so a body
/// whose pixels are larger than that looks the same. The same mesh gives the same triangles.
std::vector<std::uint32_t> coarser(const SkinnedMesh& mesh, float cell);

}  // namespace docent::scene
