#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace docent {

/// A decoded picture: rows from the top, four bytes a pixel (sRGB red, green, blue and straight
/// alpha). Invariant: rgba.size() == 4 * width * height.
struct Pixels {
  std::uint32_t width = 0, height = 0;
  std::vector<std::byte> rgba;
};

}  // namespace docent
