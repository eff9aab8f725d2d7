#include "content/import/gltf/colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace docent::import::gltf {
namespace {

/// Which of `size` texels a coordinate means.
std::uint32_t texel(float at, std::uint32_t size, Wrap wrap) {
  const float whole = std::floor(at);
  float share = at - whole;
  if (wrap == Wrap::Clamp) share = std::clamp(at, 0.0F, 1.0F);
  if (wrap == Wrap::Mirror && std::fmod(std::abs(whole), 2.0F) > 0.5F) share = 1 - share;
  if (!std::isfinite(share)) share = 0;
  return std::min(static_cast<std::uint32_t>(share * static_cast<float>(size)), size - 1);
}

Vec4 picture_at(const Model& model, const Material& material, glm::vec2 uv) {
  if (material.image < 0) return Vec4{1};
  const Pixels& picture = model.images[entry(material.image)];
  if (picture.rgba.empty()) return Vec4{1};
  const std::size_t x = texel(uv.x, picture.width, material.wrap[0]);
  const std::size_t y = texel(uv.y, picture.height, material.wrap[1]);
  const std::byte* p = picture.rgba.data() + 4 * (y * picture.width + x);
  return {linear_of(p[0]), linear_of(p[1]), linear_of(p[2]),
          static_cast<float>(std::to_integer<int>(p[3])) / 255};
}

}  // namespace

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

Vec4 colour_at(const Model& model, std::int32_t material, glm::vec2 uv, Vec4 tint) {
  if (material < 0) return tint;
  const Material& it = model.materials[entry(material)];
  Vec4 colour = it.base * tint * picture_at(model, it, uv);
  for (int i = 0; i < 3; ++i) colour[i] = std::min(colour[i] + it.emissive[i], 1.0F);
  return colour;
}

bool has_picture(const Model& model, std::int32_t material) {
  if (material < 0) return false;
  const std::int32_t image = model.materials[entry(material)].image;
  return image >= 0 && !model.images[entry(image)].rgba.empty();
}

}  // namespace docent::import::gltf
