#include "runtime/interface/button_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace docent::interface {

float ButtonGrid::height() const noexcept {
  if (heights.empty()) return 0;
  return std::accumulate(heights.begin(), heights.end(), 0.0F) +
         gap * static_cast<float>(heights.size() - 1);
}

PixelBox ButtonGrid::cell(const PixelBox& box, std::size_t index) const noexcept {
  const std::size_t row = index / columns, column = index % columns;
  float y = box.y;
  for (std::size_t i = 0; i < row; ++i) y += heights[i] + gap;
  const std::size_t in_row = std::min<std::size_t>(columns, count - row * columns);
  const auto all = static_cast<float>(columns), here = static_cast<float>(in_row);
  const float wide = fills ? std::floor(all * (width + gap) / here - gap) : width;
  return {box.x + static_cast<float>(column) * (wide + gap), y, wide, heights[row]};
}

bool have_room(Sheet& sheet, std::span<const std::int32_t> controls, float width,
               std::uint32_t lines) {
  return std::ranges::all_of(controls, [&](std::int32_t control) {
    const TextStyle style = sheet.word_style(control, width);
    const std::string_view word = sheet.label_of(control);
    return sheet.longest_word(style, word) <= width &&
           sheet.extent(style, word, width).lines <= lines;
  });
}

ButtonGrid grid_of(Sheet& sheet, std::span<const std::int32_t> controls, const GridRules& rules) {
  ButtonGrid grid{.gap = rules.gap, .count = controls.size(), .fills = rules.fills, .heights = {}};
  if (controls.empty()) return grid;
  const auto count = static_cast<std::uint32_t>(controls.size());
  const float touch = sheet.measures().touch;
  const auto width_in = [&](std::uint32_t columns) {
    const auto n = static_cast<float>(columns);
    return std::floor((rules.width - (n - 1) * rules.gap) / n);
  };
  for (grid.columns = std::min(count, rules.most_columns); grid.columns > 1; --grid.columns) {
    const float width = width_in(grid.columns);
    if (width >= touch && have_room(sheet, controls, width - rules.margin, rules.lines)) break;
  }
  // Rows of the same length: four and one would be three and two.
  const std::uint32_t rows = (count + grid.columns - 1) / grid.columns;
  grid.columns = (count + rows - 1) / rows;
  grid.width = width_in(grid.columns);
  const float pad = std::round(sheet.measures().unit / 2);
  for (std::uint32_t first = 0; first < count; first += grid.columns) {
    float height = std::max(touch, rules.least);
    for (const std::int32_t control :
         controls.subspan(first, std::min(grid.columns, count - first))) {
      const float room = grid.width - rules.margin;
      const TextPiece word =
          sheet.extent(sheet.word_style(control, room), sheet.label_of(control), room);
      height = std::max(height, word.height + rules.above + 2 * pad);
    }
    grid.heights.push_back(std::ceil(height));
  }
  return grid;
}

}  // namespace docent::interface
