#include "platform/gles/extent.h"

#include <cmath>
#include <cstdint>

#include "runtime/scene/uncovered.h"

namespace docent::gles {

std::array<Region, 4> beside(const Region& other, const Region& region) noexcept {
  if (other.is_empty()) return {region};
  const Region across = common(region, {region.left, other.low, region.right, other.high});
  return {common({across.left, across.low, other.left, across.high}, across),
          common({other.right, across.low, across.right, across.high}, across),
          common({region.left, region.low, region.right, other.low}, region),
          common({region.left, other.high, region.right, region.high}, region)};
}

PixelSize scaled(PixelSize size, float share) noexcept {
  const auto fewer = [&](std::uint32_t all) {
    return std::max(1U, static_cast<std::uint32_t>(std::lround(share * static_cast<float>(all))));
  };
  return {fewer(size.width), fewer(size.height)};
}

Region scaled(const Region& part, PixelSize from, PixelSize to) noexcept {
  const auto below = [](GLint at, std::uint32_t of, std::uint32_t in) {
    return std::max(0, static_cast<GLint>(std::int64_t{at} * in / of) - 1);
  };
  const auto above = [](GLint at, std::uint32_t of, std::uint32_t in) {
    return std::min(static_cast<GLint>(in),
                    static_cast<GLint>((std::int64_t{at} * in + of - 1) / of) + 1);
  };
  return {below(part.left, from.width, to.width), below(part.low, from.height, to.height),
          above(part.right, from.width, to.width), above(part.high, from.height, to.height)};
}

Region region_of(const Extent& extent, PixelSize picture) noexcept {
  constexpr float margin = 2;
  if (extent.outside != 0) return {};
  const auto pixel = [](float clip, std::uint32_t size, float beyond) {
    const auto most = static_cast<float>(size);
    const float at = (0.5F + 0.5F * clip) * most;
    return static_cast<GLint>(
        std::clamp(beyond < 0 ? std::floor(at) + beyond : std::ceil(at) + beyond, 0.0F, most));
  };
  const bool is_whole = extent.reaches_behind_eye;
  return {is_whole ? 0 : pixel(extent.left, picture.width, -margin),
          is_whole ? 0 : pixel(extent.low, picture.height, -margin),
          pixel(is_whole ? 1 : extent.right, picture.width, margin),
          pixel(is_whole ? 1 : extent.high, picture.height, margin)};
}

Extent extent_of(const scene::Rect& rect) noexcept {
  if (rect.width <= 0) return {};
  return {.left = 2 * rect.x - 1,
          .right = 2 * (rect.x + rect.width) - 1,
          .low = 1 - 2 * (rect.y + rect.height),
          .high = 1 - 2 * rect.y,
          .outside = 0};
}

Region region_behind(const scene::Quad& quad, PixelSize picture) noexcept {
  if (!scene::is_opaque(quad)) return {};
  const auto width = static_cast<float>(picture.width);
  const auto height = static_cast<float>(picture.height);
  // A corner's arc is nowhere further from its square's corner than this share of its radius, and
  // an edge is soft by half a pixel.
  constexpr float beside_arc = 0.293F;
  const float inset = 1 + beside_arc * quad.corner * std::min(width, height);
  const auto from = [&](float at, float most) {
    return static_cast<GLint>(std::ceil(std::clamp(at + inset, 0.0F, most)));
  };
  const auto to = [&](float at, float most) {
    return static_cast<GLint>(std::floor(std::clamp(at - inset, 0.0F, most)));
  };
  const scene::Rect& r = quad.rect;
  return {from(r.x * width, width), from((1 - r.y - r.height) * height, height),
          to((r.x + r.width) * width, width), to((1 - r.y) * height, height)};
}

}  // namespace docent::gles
