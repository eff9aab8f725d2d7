#pragma once

#include <cstdint>
#include <functional>

#include "runtime/model/pixels.h"

namespace docent::interface {

/// Makes an image of the museum (an index into Museum::images) ready to be drawn `width` by
/// `height` pixels large: the largest part of that shape about its middle, scaled down. An image
/// with too few pixels is not scaled up; one that cannot be decoded, or does not exist, gives no
/// pixels. Given to the layout by whoever can decode; called on the worker, never in a frame.
using SetPicture =
    std::function<Pixels(std::uint32_t image, std::uint32_t width, std::uint32_t height)>;

}  // namespace docent::interface
