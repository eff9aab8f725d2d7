#include "content/film/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace docent::film {

std::uint32_t sheet_columns(std::size_t pictures) noexcept {
  return std::max(
      1U, static_cast<std::uint32_t>(std::ceil(std::sqrt(2.0 * static_cast<double>(pictures)))));
}

Pixels contact_sheet(std::span<const Pixels> pictures, std::uint32_t columns) {
  if (pictures.empty() || columns == 0) return {};
  const std::size_t count = pictures.size();
  const std::size_t across = std::min<std::size_t>(columns, count);
  const std::size_t down = (count + across - 1) / across;
  const std::size_t width = pictures[0].width, height = pictures[0].height;
  Pixels sheet{.width = static_cast<std::uint32_t>(width * across),
               .height = static_cast<std::uint32_t>(height * down),
               .rgba = {}};
  const std::size_t row_bytes = 4 * width;
  sheet.rgba.assign(row_bytes * across * height * down, std::byte{255});
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t y = 0; y < height; ++y) {
      const std::size_t row = (i / across) * height + y;
      std::ranges::copy(std::span(pictures[i].rgba).subspan(y * row_bytes, row_bytes),
                        sheet.rgba.begin() +
                            static_cast<std::ptrdiff_t>((row * across + i % across) * row_bytes));
    }
  return sheet;
}

}  // namespace docent::film
