#pragma once

#include "platform/image/image.h"

namespace docent::image {

enum class JpegPart : std::uint8_t { Header, Pixels };

/// Decodes a JPEG file, or only its size. `least_side`: as decode_at_least(); 0: the whole.
Result<Pixels> decode_jpeg(std::span<const std::byte> file, const ImageLimits& limits,
                           JpegPart part, std::uint32_t least_side = 0);

/// The sentence for a picture that is larger than the limits; empty where it is not.
std::string too_large(std::uint64_t width, std::uint64_t height, const ImageLimits& limits);

}  // namespace docent::image
