#include "content/character/colour.h"

#include <cmath>

#include "content/import/gltf/colour.h"

namespace docent::character {

const import::gltf::Material* Colours::material_of(const SurfaceVertex& vertex) const {
  return vertex.material < 0 ? nullptr
                             : &model_.materials[static_cast<std::size_t>(vertex.material)];
}

Vec4 Colours::at(const SurfaceVertex& vertex) const {
  return import::gltf::colour_at(model_, vertex.material, vertex.uv, vertex.tint);
}

bool Colours::is_seen(const SurfaceVertex& vertex) const {
  const import::gltf::Material* material = material_of(vertex);
  if (material == nullptr || material->alpha == import::gltf::AlphaMode::Opaque) return true;
  constexpr float clear = 0.35F;
  return at(vertex).w >=
         (material->alpha == import::gltf::AlphaMode::Mask ? material->alpha_cutoff : clear);
}

bool Colours::has_picture(const SurfaceVertex& vertex) const {
  return import::gltf::has_picture(model_, vertex.material);
}

VertexColour srgb_of(Vec4 linear) {
  const auto byte = [](float part) {
    return static_cast<std::uint8_t>(std::lround(255 * import::gltf::srgb_of(part)));
  };
  return {byte(linear.x), byte(linear.y), byte(linear.z)};
}

}  // namespace docent::character
