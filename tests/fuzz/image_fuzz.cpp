#include <cstddef>
#include <cstdint>
#include <span>

#include "platform/image/image.h"

/// Any bytes as a picture file: refused, or whole.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr docent::image::ImageLimits limits{.side = 512, .pixels = 65536};
  const auto file = std::as_bytes(std::span(data, size));
  const auto header = docent::image::read_image_size(file, limits);
  const auto picture = docent::image::decode_image(file, limits);
  if (!picture) {
    if (picture.error().what.empty()) __builtin_trap();
    return 0;
  }
  if (!header || header->width != picture->width || header->height != picture->height)
    __builtin_trap();
  if (picture->rgba.size() != std::size_t{4} * picture->width * picture->height) __builtin_trap();
  return 0;
}
