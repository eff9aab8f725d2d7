#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/model/pixels.h"

namespace docent::video {

/// A decoded frame: brightness, and two planes of colour at half its width and height, rounded up
/// (4:2:0, eight bits). Borrows from its decoder.
struct Planes {
  std::uint32_t width = 0, height = 0;  ///< Pixels, at least 1.
  const std::byte *y = nullptr, *u = nullptr, *v = nullptr;
  std::ptrdiff_t y_stride = 0, uv_stride = 0;  ///< Bytes from a row to the one below.
  bool is_bt709 = false;                       ///< Else ITU-R BT.601, as VP8 always is.
  bool is_full_range = false;                  ///< Else brightness is 16 to 235.
};

/// Fills `picture`, as large as it is, with the largest middle part of the frame that has its
/// shape, as image::fill does with pictures; where it is smaller, each pixel is the mean of its
/// area, in the values as they are coded. A picture without pixels stays so. Does not allocate.
void fill_pixels(const Planes& planes, Pixels& picture) noexcept;

/// The whole frame, pixel for pixel.
Pixels whole_picture(const Planes& planes);

}  // namespace docent::video
