#pragma once

#include <algorithm>
#include <string_view>

#include "runtime/scene/text.h"

namespace docent::test {

/// Letters as boxes: views without fonts.
inline TextBitmap boxes(const TextStyle& style, std::string_view text, std::uint32_t width) {
  TextBitmap bitmap;
  bitmap.lines = 1;
  bitmap.width = std::min<std::uint32_t>(static_cast<std::uint32_t>(8 * text.size() + 1),
                                         width == 0 ? 4000 : width);
  bitmap.height = static_cast<std::uint32_t>(style.size);
  bitmap.coverage.resize(std::size_t{bitmap.width} * bitmap.height, 255);
  return bitmap;
}

}  // namespace docent::test
