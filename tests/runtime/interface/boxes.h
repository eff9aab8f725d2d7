#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "runtime/interface/text.h"

namespace docent::test {

/// Letters as boxes of six tenths of their size: layout without fonts, quick enough for properties.
inline interface::TextBitmap boxes(const interface::TextStyle& style, std::string_view text,
                                   std::uint32_t width) {
  std::size_t letters = 0;
  for (const char c : text) letters += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  const float line = std::round(style.size * style.line_height);
  const float whole = static_cast<float>(letters) * style.size * 0.6F;
  const float wide = width == 0 ? whole : static_cast<float>(width);
  const auto lines = static_cast<std::uint32_t>(std::max(1.0F, std::ceil(whole / wide)));
  interface::TextBitmap bitmap;
  bitmap.cut = lines > style.max_lines;
  bitmap.lines = std::min<std::uint32_t>(lines, style.max_lines);
  bitmap.width = static_cast<std::uint32_t>(std::max(1.0F, std::min(whole, wide)));
  bitmap.height = bitmap.lines * static_cast<std::uint32_t>(line);
  bitmap.coverage.resize(std::size_t{bitmap.width} * bitmap.height, 255);
  return bitmap;
}

}  // namespace docent::test
