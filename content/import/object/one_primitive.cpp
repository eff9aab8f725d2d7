#include "content/import/object/one_primitive.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace docent::import::object {

gltf::Model scene_of(std::vector<gltf::Primitive> primitives) {
  std::erase_if(primitives, [](const gltf::Primitive& p) { return p.indices.empty(); });
  gltf::Model model;
  model.nodes.push_back({.name = "", .children = {}, .mesh = 0, .in_scene = true});
  model.order = {0};
  model.meshes.push_back({.name = "", .primitives = std::move(primitives)});
  return model;
}

void add_polygon(const std::vector<std::uint32_t>& corners, gltf::Primitive& primitive) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const std::uint32_t a = corners[0], b = corners[i], c = corners[i + 1];
    if (a != b && b != c && c != a) primitive.indices.insert(primitive.indices.end(), {a, b, c});
  }
}

float linear_of(float srgb) {
  const float s = std::clamp(srgb, 0.0F, 1.0F);
  return s <= 0.04045F ? s / 12.92F : std::pow((s + 0.055F) / 1.055F, 2.4F);
}

}  // namespace docent::import::object
