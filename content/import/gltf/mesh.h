#pragma once

#include "content/import/gltf/model.h"
#include "content/import/gltf/source.h"

namespace docent::import::gltf {

/// Reads one of the file's meshes. `joints` is how many the skin has that it hangs on; 0: none, and
/// joints and weights are left out.
Mesh read_mesh(Source& source, std::size_t mesh, std::size_t joints,
               const std::vector<Material>& materials);

}  // namespace docent::import::gltf
