#pragma once

#include "content/import/gltf/model.h"
#include "content/import/gltf/source.h"

namespace docent::import::gltf {

/// Reads the tree of nodes, which of them the scene shows, and the skins.
void read_scene(Source& source, Model& model);

/// Reads all materials, as far as they are kept: base colour, opacity, glow.
std::vector<Material> read_materials(Source& source);

/// The picture that materials call by this index, decoded; empty, and a warning, where it cannot
/// be.
Pixels read_image(Source& source, std::size_t index);

/// Warns of parts that nothing here needs and that are wrong: pictures of relief, animations,
/// meshes that no scene shows.
void look_over(Source& source);

/// What VRM's extensions say; nothing where the file has none.
Vrm read_vrm(Source& source, std::size_t nodes);

}  // namespace docent::import::gltf
