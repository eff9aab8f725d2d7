#pragma once

#include <cstdint>
#include <functional>

#include "runtime/model/pixels.h"

namespace docent::interface {

/// Makes an image of the museum ready to be drawn `width` by `height` pixels large: its largest
/// middle part of that shape, made smaller. An image with too few pixels keeps those it has; one
/// that cannot be decoded, or is not there, has none. Given to the layout by whoever can decode;
/// called on the worker, never in a frame.
using SetPicture =
    std::function<Pixels(std::uint32_t image, std::uint32_t width, std::uint32_t height)>;

}  // namespace docent::interface
