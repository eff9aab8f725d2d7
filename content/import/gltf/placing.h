#pragma once

#include <glm/mat3x3.hpp>

#include "content/import/gltf/model.h"

namespace docent::import::gltf {

/// Where each node is, in the frame of the scene: one matrix a node.
std::vector<Mat4> world_of_nodes(const Model& model);

/// Where a primitive's vertices are: the transform of its node, or for a skin that of each vertex,
/// blended of its joints'.
class Placing {
 public:
  /// `world` has a matrix a node, and outlives this as the primitive does.
  Placing(const Model& model, const std::vector<Mat4>& world, std::int32_t node,
          const Primitive& primitive);
  Mat4 at(std::size_t vertex) const;

 private:
  const Primitive& primitive_;
  Mat4 rigid_;
  std::vector<Mat4> joint_;
};

/// Calls `take(node, primitive)` for all that the scene shows, parents first.
template <typename Take>
void for_each_primitive(const Model& model, Take take) {
  for (const std::int32_t n : model.order) {
    const Node& node = model.nodes[entry(n)];
    if (!node.in_scene || node.mesh < 0) continue;
    for (const Primitive& primitive : model.meshes[entry(node.mesh)].primitives) take(n, primitive);
  }
}

}  // namespace docent::import::gltf
