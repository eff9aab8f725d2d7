#include "content/avatar/avatar.h"

#include <algorithm>

#include <glm/matrix.hpp>

#include "content/avatar/layers.h"
#include "content/avatar/occlusion.h"
#include "content/avatar/simplify.h"
#include "content/content_error.h"

namespace docent::avatar {
namespace {

/// Longest edge that simplification may make, in cells.
constexpr float longest_edge = 3.2F;
/// Triangles are left out where all three corners lie this deep under another layer, metres.
constexpr float covered_depth = 0.006F;
/// No body of ordinary stature is larger than that, metres.
constexpr float most_extent = 5;

/// Appends the visible part of a layer's surface to the mesh.
void add_layer(const Layer& layer, const SkinWeights& weights, const Occlusion& occlusion,
               SkinnedMesh& mesh) {
  TriangleSurface surface = polygonise(layer.solid, layer.box, layer.cell);
  simplify(surface, {.error = layer.error, .edge = longest_edge * layer.cell});
  std::vector<bool> hidden(surface.position.size(), false);
  if (layer.covered)
    for (std::size_t v = 0; v < hidden.size(); ++v)
      hidden[v] = layer.covered(surface.position[v]) < -covered_depth;

  constexpr std::uint32_t unused = 0xFFFFFFFF;
  std::vector<std::uint32_t> moved_to(surface.position.size(), unused);
  const auto vertex = [&](std::uint32_t v) {
    if (moved_to[v] == unused) {
      moved_to[v] = static_cast<std::uint32_t>(mesh.vertices.size());
      const Vec3 normal = gradient_of(layer.solid, surface.position[v], 0.35F * layer.cell);
      const JointShares shares = weights.at(surface.position[v], layer.region);
      mesh.vertices.push_back({.position = surface.position[v],
                               .normal = normal,
                               .joint = shares.joint,
                               .weight = shares.weight,
                               .material = layer.material,
                               .occlusion = occlusion.at(surface.position[v], normal)});
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
  const BodyShape body = body_of(stand_at_ease(skeleton));
  const SkinWeights weights(skeleton, body);
  const std::vector<Layer> layers = layers_of(body);

  Box3 whole = layers.front().box;
  for (const Layer& layer : layers) {
    whole.low = glm::min(whole.low, layer.box.low);
    whole.high = glm::max(whole.high, layer.box.high);
  }
  const Vec3 extent = whole.high - whole.low;
  if (!(std::max({extent.x, extent.y, extent.z}) < most_extent * body.scale))
    throw content::ContentError(
        {}, 0, 0, "no-standing-pose",
        "no body can be read from the clips' skeleton, which does not stand upright "
        "in its rest pose",
        "export it with a T-pose or an A-pose as the rest pose");
  const Occlusion occlusion(layers, whole, 0.026F * body.scale);

  SkinnedMesh mesh;
  for (const Layer& layer : layers) add_layer(layer, weights, occlusion, mesh);
  for (const Mat4& world : body.stance.world) mesh.inverse_bind.push_back(glm::inverse(world));
  return mesh;
}

}  // namespace docent::avatar
