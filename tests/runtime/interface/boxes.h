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
  const float line = std::round(style.size * style.line_height);
  float whole = 0;  // the longest paragraph
  std::uint32_t lines = 0;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::size_t letters = 0;
    for (const char c : text.substr(at, end - at))
      letters += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    const float paragraph = static_cast<float>(letters) * style.size * 0.6F;
    const float room = width == 0 ? std::max(1.0F, paragraph) : static_cast<float>(width);
    lines += static_cast<std::uint32_t>(std::max(1.0F, std::ceil(paragraph / room)));
    whole = std::max(whole, paragraph);
    at = end + 1;
  }
  const float wide = width == 0 ? whole : static_cast<float>(width);
  interface::TextBitmap bitmap;
  bitmap.cut = style.max_lines > 0 && lines > style.max_lines;
  bitmap.lines = bitmap.cut ? style.max_lines : lines;
  bitmap.width = static_cast<std::uint32_t>(std::max(1.0F, std::min(whole, wide)));
  const std::uint32_t first = std::min<std::uint32_t>(style.first_line, bitmap.lines);
  const std::uint32_t drawn = style.line_count == 0
                                  ? bitmap.lines
                                  : std::min<std::uint32_t>(style.line_count, bitmap.lines - first);
  bitmap.height = drawn * static_cast<std::uint32_t>(line);
  bitmap.coverage.resize(std::size_t{bitmap.width} * bitmap.height, 255);
  return bitmap;
}

}  // namespace docent::test
