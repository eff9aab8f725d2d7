#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <string>

#include "content/content_error.h"
#include "content/import/picture/read_picture.h"

namespace docent::import {

inline content::ContentError picture_error(const std::string& what) {
  return {{}, 0, 0, "unreadable-image", what, "export it again as PNG, JPEG or SVG"};
}

/// Refuses what is too large or holds nothing.
inline void check_picture_size(std::uint64_t width, std::uint64_t height,
                               const PictureLimits& limits) {
  if (width == 0 || height == 0) throw picture_error("this picture has no pixels");
  if (width > limits.side || height > limits.side || width * height > limits.pixels)
    throw picture_error(
        fmt::format("this picture is {} x {} pixels; at most {} a side and {} in all can be taken",
                    width, height, limits.side, limits.pixels));
}

}  // namespace docent::import
