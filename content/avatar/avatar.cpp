#include "content/avatar/avatar.h"

#include <glm/matrix.hpp>

#include "content/avatar/layers.h"
#include "content/avatar/occlusion.h"

namespace docent {
namespace {

/// Covered triangles are dropped where all three corners lie this deep, in cells.
constexpr float covered_depth = 0.8F;

/// Appends the visible part of a layer's surface to the mesh.
void add_layer(const Layer& layer, const SkinWeights& weights, const Occlusion& occlusion,
               SkinnedMesh& mesh) {
  const Surface3 surface = polygonise(layer.solid, layer.box, layer.cell);
  std::vector<bool> hidden(surface.position.size(), false);
  if (layer.covered)
    for (std::size_t v = 0; v < hidden.size(); ++v)
      hidden[v] = layer.covered(surface.position[v]) < -covered_depth * layer.cell;

  constexpr std::uint32_t unused = 0xFFFFFFFF;
  std::vector<std::uint32_t> moved_to(surface.position.size(), unused);
  const auto vertex = [&](std::uint32_t v) {
    if (moved_to[v] == unused) {
      moved_to[v] = static_cast<std::uint32_t>(mesh.vertices.size());
      const JointShares shares = weights.at(surface.position[v], layer.region);
      mesh.vertices.push_back({.position = surface.position[v],
                               .normal = surface.normal[v],
                               .joint = shares.joint,
                               .weight = shares.weight,
                               .material = layer.material,
                               .occlusion = occlusion.at(surface.position[v], surface.normal[v])});
    }
    return moved_to[v];
  };
  for (std::size_t k = 0; k < surface.indices.size(); k += 3) {
    const std::uint32_t a = surface.indices[k];
    const std::uint32_t b = surface.indices[k + 1];
    const std::uint32_t c = surface.indices[k + 2];
    if (hidden[a] && hidden[b] && hidden[c]) continue;
    for (const std::uint32_t corner : {a, b, c}) mesh.indices.push_back(vertex(corner));
  }
}

}  // namespace

SkinnedMesh make_avatar(const Skeleton& skeleton) {
  const Body body = body_of(stand_at_ease(skeleton));
  const SkinWeights weights(skeleton, body);
  const std::vector<Layer> layers = layers_of(body);

  Box whole = layers.front().box;
  for (const Layer& layer : layers) {
    whole.low = glm::min(whole.low, layer.box.low);
    whole.high = glm::max(whole.high, layer.box.high);
  }
  const Occlusion occlusion(layers, whole, 0.026F * body.scale);

  SkinnedMesh mesh;
  for (const Layer& layer : layers) add_layer(layer, weights, occlusion, mesh);
  for (const Mat4& world : body.stance.world) mesh.inverse_bind.push_back(glm::inverse(world));
  return mesh;
}

}  // namespace docent
