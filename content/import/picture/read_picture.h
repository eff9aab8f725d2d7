#pragma once

#include <cstddef>
#include <span>

#include "runtime/model/pixels.h"

namespace docent::import {

/// What a picture may be at most; a larger one is refused before its memory is taken.
struct PictureLimits {
  std::uint32_t side = 8192;          ///< Pixels.
  std::uint64_t pixels = 32'000'000;  ///< Width times height.
};

/// The pictures that staff have and no kiosk decodes: their pixels, to be saved in another form.
/// Any bytes are safe. Throws ContentError without a file's name (`unreadable-image`) where they
/// are damaged or too large.
Pixels read_gif(std::span<const std::byte> bytes,
                const PictureLimits& limits = {});  ///< The first frame.
Pixels read_webp(std::span<const std::byte> bytes, const PictureLimits& limits = {});
Pixels read_heif(std::span<const std::byte> bytes,
                 const PictureLimits& limits = {});  ///< HEIC, AVIF.

}  // namespace docent::import
