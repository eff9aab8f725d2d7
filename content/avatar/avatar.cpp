#include "content/avatar/avatar.h"

#include <algorithm>
#include <span>

#include <glm/matrix.hpp>

#include "content/avatar/layers.h"
#include "content/avatar/occlusion.h"
#include "content/avatar/simplify.h"
#include "content/content_error.h"
#include "content/parallel.h"

namespace docent::avatar {
namespace {

/// Triangles are left out where all three corners lie this deep under another layer, metres.
constexpr float covered_depth = 0.006F;
/// No body of ordinary stature is larger than that, metres.
constexpr float most_extent = 5;

/// Leaves out the triangles that lie deep under another layer.
void leave_out_covered(const Layer& layer, TriangleSurface& surface) {
  if (!layer.covered) return;
  std::vector<bool> hidden(surface.position.size());
  for (std::size_t v = 0; v < hidden.size(); ++v)
    hidden[v] = layer.covered(surface.position[v]) < -covered_depth;
  std::vector<std::uint32_t> seen;
  for (std::size_t k = 0; k < surface.indices.size(); k += 3) {
    const auto corners = std::span(surface.indices).subspan(k, 3);
    if (!std::ranges::all_of(corners, [&](std::uint32_t v) { return hidden[v]; }))
      seen.insert(seen.end(), corners.begin(), corners.end());
  }
  surface.indices = std::move(seen);
}

/// Appends the visible part of a layer's surface to the mesh.
void add_layer(const Layer& layer, const SkinWeights& weights, const Occlusion& occlusion,
               SkinnedMesh& mesh) {
  TriangleSurface surface = polygonise(layer.solid, layer.box, layer.cell);
  leave_out_covered(layer, surface);
  simplify(surface, {.triangles = layer.triangles, .error = layer.error, .lens = layer.lens});
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vec3& place : surface.position) {
    const Vec3 normal = gradient_of(layer.solid, place, 0.5F * layer.cell);
    const JointShares shares = weights.at(place, layer.region);
    mesh.vertices.push_back({.position = place,
                             .normal = normal,
                             .joint = shares.joint,
                             .weight = shares.weight,
                             .material = layer.material,
                             .occlusion = occlusion.at(layer, place, normal)});
  }
  for (const std::uint32_t v : surface.indices) mesh.indices.push_back(first + v);
}

/// Appends the cloth of the body that comes next.
void add_cloth(const Cloth& cloth, SkinnedMesh& mesh) {
  const auto figure = static_cast<std::uint8_t>(mesh.figure_end.size());
  for (ClothNode node : cloth.node) node.figure = figure, mesh.cloth.node.push_back(node);
  for (ClothCollider limb : cloth.collider)
    limb.figure = figure, mesh.cloth.collider.push_back(limb);
}

}  // namespace

SkinnedMesh make_avatar(const Skeleton& skeleton, const Figure& figure) {
  const BodyShape body = body_of(figure, stand_at_ease(skeleton));
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
  mesh.cloth = weights.cloth();
  mesh.figure_end.push_back(static_cast<std::uint32_t>(mesh.indices.size()));
  for (const Mat4& world : body.stance.world) mesh.inverse_bind.push_back(glm::inverse(world));
  return mesh;
}

SkinnedMesh make_avatars(const Skeleton& skeleton, unsigned jobs) {
  std::array<SkinnedMesh, figures.size()> made;
  content::for_each_index(made.size(), jobs,
                          [&](std::size_t i) { made[i] = make_avatar(skeleton, figures[i]); });
  SkinnedMesh all = std::move(made[0]);
  for (const SkinnedMesh& one : std::span(made).subspan(1)) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), one.vertices.begin(), one.vertices.end());
    for (const std::uint32_t v : one.indices) all.indices.push_back(first + v);
    add_cloth(one.cloth, all);
    all.figure_end.push_back(static_cast<std::uint32_t>(all.indices.size()));
  }
  return all;
}

}  // namespace docent::avatar
