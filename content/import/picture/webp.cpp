#include <webp/decode.h>

#include <vector>

#include "content/import/picture/picture_error.h"

namespace docent::import {

Pixels read_webp(std::span<const std::byte> bytes, const PictureLimits& limits) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features{};
  if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK)
    throw picture_error("this WebP picture is damaged or cut short");
  if (features.has_animation != 0)
    throw picture_error("this WebP picture moves, and only pictures that stand still are read");
  const auto width = static_cast<std::size_t>(features.width);
  const auto height = static_cast<std::size_t>(features.height);
  check_picture_size(width, height, limits);
  Pixels pixels{.width = static_cast<std::uint32_t>(width),
                .height = static_cast<std::uint32_t>(height),
                .rgba = std::vector<std::byte>(4 * width * height)};
  if (WebPDecodeRGBAInto(data, bytes.size(), reinterpret_cast<std::uint8_t*>(pixels.rgba.data()),
                         pixels.rgba.size(), static_cast<int>(4 * width)) == nullptr)
    throw picture_error("this WebP picture is damaged or cut short");
  return pixels;
}

}  // namespace docent::import
