#include "content/character/colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace docent::character {
namespace {

float linear_of(std::byte value) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> made{};
    for (std::size_t i = 0; i < made.size(); ++i) {
      const float s = static_cast<float>(i) / 255;
      made[i] = s <= 0.04045F ? s / 12.92F : std::pow((s + 0.055F) / 1.055F, 2.4F);
    }
    return made;
  }();
  return table[static_cast<std::size_t>(value)];
}

float srgb_of(float linear) {
  const float c = std::clamp(linear, 0.0F, 1.0F);
  return c <= 0.0031308F ? 12.92F * c : 1.055F * std::pow(c, 1 / 2.4F) - 0.055F;
}

/// Which of `size` texels a coordinate means.
std::uint32_t texel(float at, std::uint32_t size, import::gltf::Wrap wrap) {
  const float whole = std::floor(at);
  float share = at - whole;
  if (wrap == import::gltf::Wrap::Clamp) share = std::clamp(at, 0.0F, 1.0F);
  if (wrap == import::gltf::Wrap::Mirror && std::fmod(std::abs(whole), 2.0F) > 0.5F)
    share = 1 - share;
  if (!std::isfinite(share)) share = 0;
  return std::min(static_cast<std::uint32_t>(share * static_cast<float>(size)), size - 1);
}

}  // namespace

const import::gltf::Material* Colours::material_of(const SurfaceVertex& vertex) const {
  return vertex.material < 0 ? nullptr
                             : &model_.materials[static_cast<std::size_t>(vertex.material)];
}

Vec4 Colours::picture_at(const import::gltf::Material& material, glm::vec2 uv) const {
  if (material.image < 0) return Vec4{1};
  const Pixels& picture = model_.images[static_cast<std::size_t>(material.image)];
  if (picture.rgba.empty()) return Vec4{1};
  const std::size_t x = texel(uv.x, picture.width, material.wrap[0]);
  const std::size_t y = texel(uv.y, picture.height, material.wrap[1]);
  const std::byte* p = picture.rgba.data() + 4 * (y * picture.width + x);
  return {linear_of(p[0]), linear_of(p[1]), linear_of(p[2]),
          static_cast<float>(std::to_integer<int>(p[3])) / 255};
}

Vec4 Colours::at(const SurfaceVertex& vertex) const {
  const import::gltf::Material* material = material_of(vertex);
  if (material == nullptr) return vertex.tint;
  Vec4 colour = material->base * vertex.tint * picture_at(*material, vertex.uv);
  for (int i = 0; i < 3; ++i) colour[i] = std::min(colour[i] + material->emissive[i], 1.0F);
  return colour;
}

bool Colours::is_seen(const SurfaceVertex& vertex) const {
  const import::gltf::Material* material = material_of(vertex);
  if (material == nullptr || material->alpha == import::gltf::AlphaMode::Opaque) return true;
  constexpr float clear = 0.35F;
  return at(vertex).w >=
         (material->alpha == import::gltf::AlphaMode::Mask ? material->alpha_cutoff : clear);
}

bool Colours::has_picture(const SurfaceVertex& vertex) const {
  const import::gltf::Material* material = material_of(vertex);
  return material != nullptr && material->image >= 0 &&
         !model_.images[static_cast<std::size_t>(material->image)].rgba.empty();
}

VertexColour srgb_of(Vec4 linear) {
  const auto byte = [](float part) {
    return static_cast<std::uint8_t>(std::lround(255 * srgb_of(part)));
  };
  return {byte(linear.x), byte(linear.y), byte(linear.z)};
}

}  // namespace docent::character
