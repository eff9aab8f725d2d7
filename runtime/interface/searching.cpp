/// The screen on which a visitor types, and sees what is found.
#include "runtime/interface/searching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/interface/face.h"
#include "runtime/interface/finder.h"
#include "runtime/interface/key_board.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/phrases.h"
#include "runtime/search/compose.h"

namespace docent::interface {
namespace {

/// A text without its first letter.
std::string_view end_of(std::string_view text) noexcept {
  std::size_t first = 1;
  while (first < text.size() && (static_cast<unsigned char>(text[first]) & 0xC0U) == 0x80U) ++first;
  return text.substr(first);
}

}  // namespace

void draw_typed(Sheet& sheet, const PixelBox& box) {
  const Measures& m = sheet.measures();
  const Typed& typed = sheet.request().state.typed;
  sheet.outline(box, -1);
  const float side = std::round(0.5F * box.height), pad = m.unit;
  sheet.pictogram(Pictogram::Search, {box.x + pad, box.y, side, box.height},
                  sheet.theme().quiet_ink);
  const float x = box.x + side + 2 * pad, width = box.right() - pad - x;
  const std::optional<std::uint32_t>& browses = sheet.request().state.browses;
  const bool is_empty = typed.count == 0;
  const std::string text = !is_empty ? search::composed(typed.letters())
                           : browses
                               ? std::string(sheet.local(*group_of(sheet.museum(), *browses).title))
                               : std::string(sheet.word("search_hint"));
  TextStyle style = sheet.style(is_empty ? Letters::Body : Letters::Lead);
  style.weight = is_empty ? 400 : 500;
  style.line_height = is_empty ? 1.15F : 1.4F;
  if (!is_empty && sheet.extent(style, text, 1e4F).width > width - m.unit) {
    style.size = sheet.style(Letters::Body).size;
    style.line_height = 1.15F;
  }
  std::string_view shown = text;
  while (!shown.empty() && sheet.height_of(style, shown, width - m.unit) > box.height - m.unit)
    shown = is_empty ? std::string_view() : end_of(shown);
  if (is_empty && shown.empty()) return;
  const TextPiece piece = sheet.set(style, shown, width - m.unit);
  sheet.piece(piece, x, box.y + (box.height - piece.height) / 2, width, Align::Start,
              is_empty ? sheet.theme().quiet_ink : sheet.theme().ink);
  if (is_empty || piece.lines > 1) return;
  const float caret = std::max(2.0F, std::round(0.3F * m.unit)),
              tall = std::round(0.56F * box.height);
  sheet.fill({std::round(x + piece.width + caret), std::round(box.y + (box.height - tall) / 2),
              caret, tall},
             sheet.theme().ink, 0);
}

std::string found_line(const Sheet& sheet) {
  const InterfaceState& state = sheet.request().state;
  const bool is_open = state.typed.count == 0 && !state.browses;
  if (!state.found.is_current || (is_open && state.found.total == 0)) return {};
  if (is_open) return std::string(sheet.word("search_browse"));
  if (state.found.total == 0) return std::string(sheet.word("search_none"));
  return filled_in(sheet.word("search_found"), "n",
                   number_in(sheet.museum(), state.language, static_cast<long>(state.found.total)));
}

namespace {

/// The most rows of keys that a language has, with the last one.
constexpr float most_rows = 7;

/// Where things lie on the searching screen. Pixels.
struct SearchShape {
  bool is_on_panel = true;      ///< What was found; else it is on the model's lower edge.
  bool has_keys_below = false;  ///< On the panel, too: it lies along the lower edge.
  float results = 0;            ///< How high what was found is, with what is typed above it.
  std::uint32_t columns = 1, rows = 1;
};

SearchShape search_shape(const ScreenShape& shape) noexcept {
  const Measures m = measures_of(shape);
  const KeySizes keys = key_sizes(shape);
  const ListShape list = list_shape(shape);
  const auto height = static_cast<float>(shape.height);
  const float panel = panel_of(shape).height * height - 2 * m.margin - m.touch - m.gap;
  const float head = 2 * (m.touch + m.gap), row = list.row_height + list.row_gap;
  const float least = head + std::max(row, 2 * m.touch + m.gap);  // it may have to scroll
  SearchShape search;
  search.columns = list.columns;
  search.results = panel;
  if (!is_landscape(shape)) {
    constexpr float most_of_model = 0.42F;
    search.has_keys_below = true;
    search.results = panel - most_rows * (keys.least + keys.gap) - m.gap;
    search.is_on_panel = search.results >= least;
    if (!search.is_on_panel)
      search.results = std::max(least, most_of_model * free_part_of(shape, false).height * height);
  }
  search.rows = static_cast<std::uint32_t>(
      std::clamp(std::floor((search.results - head + list.row_gap) / row), 1.0F, 12.0F));
  return search;
}

/// How many things are found, and the keys that turn pages where there are several.
void draw_count(Sheet& sheet, const PixelBox& box, std::uint32_t per_page) {
  const Measures& m = sheet.measures();
  const InterfaceState& state = sheet.request().state;
  const bool has_pages = page_count(sheet.museum(), state, per_page) > 1;
  const float third = std::floor((box.width - 2 * m.gap) / 3);
  if (has_pages) {
    const std::array buttons{sheet.control("page:previous"), sheet.control("page:next")};
    sheet.button(buttons[0], {box.x + third + m.gap, box.y, third, box.height},
                 Sheet::Emphasis::Soft);
    sheet.button(buttons[1], {box.right() - third, box.y, third, box.height},
                 Sheet::Emphasis::Soft);
  }
  const bool is_open = state.typed.count == 0 && !state.browses;
  if (is_open && has_pages) return;  // there is no room to say what the list is; it says so itself
  const std::string text = found_line(sheet);
  if (text.empty()) return;
  TextStyle style = sheet.style(Letters::Small);
  style.line_height = 1.2F;
  const float width = has_pages ? third : box.width;
  const TextPiece piece = sheet.set(style, text, width);
  sheet.piece(piece, box.x, box.y + (box.height - piece.height) / 2, width, Align::Start,
              sheet.theme().quiet_ink);
}

/// What is typed, and what was found, above the foot where that lies in the same box.
void draw_results(Sheet& sheet, const PixelBox& box, std::vector<Block> foot) {
  const Measures& m = sheet.measures();
  const SearchShape shape = search_shape(sheet.request().shape);
  draw_typed(sheet, {box.x, box.y, box.width, m.touch});
  const float count = box.y + m.touch + m.gap;
  draw_count(sheet, {box.x, count, box.width, m.touch}, shape.columns * shape.rows);
  const float top = count + m.touch + m.gap;
  const PixelBox list{box.x, top, box.width, box.bottom() - top};
  lay_out_column(sheet, list, list_blocks(sheet, list), std::move(foot));
}

/// A board on the model's lower edge.
PixelBox draw_board(Sheet& sheet, const PixelBox& free, float height) {
  const Measures& m = sheet.measures();
  const PixelBox board{free.x, free.bottom() - height, free.width, height};
  sheet.shadow(board, 2 * m.unit, 0.12F);
  sheet.fill(board, sheet.theme().paper, 0);
  return board;
}

}  // namespace

std::uint32_t found_per_page(const ScreenShape& shape) noexcept {
  const SearchShape search = search_shape(shape);
  return search.columns * search.rows;
}

void lay_out_searching(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  std::vector<Block> foot = foot_blocks(sheet, sheet.control("back") >= 0 ? "back" : "home");
  const SearchShape shape = search_shape(sheet.request().shape);
  if (shape.is_on_panel && !shape.has_keys_below)
    return draw_results(sheet, content, std::move(foot));
  const float foot_height = height_of(foot, content.width);
  const float bottom = content.bottom() - foot_height - m.gap;
  lay_out_column(sheet, {content.x, bottom + m.gap, content.width, foot_height}, {},
                 std::move(foot));
  float top = content.y;
  if (shape.is_on_panel) {
    draw_results(sheet, {content.x, content.y, content.width, shape.results}, {});
    top += shape.results + m.gap;
  }
  if (!shape.has_keys_below) return;
  // Keys may come nearer to the glass's edge than words do.
  const float more = m.margin - m.unit;
  const PixelBox room{content.x - more, top, content.width + 2 * more, bottom - top};
  const KeyBoard keys = key_board(sheet, room.width, room.height);
  const float spare = std::max(0.0F, room.height - keys.height());
  draw_keys(sheet, keys, {room.x, std::round(room.y + spare / 2), room.width, keys.height()});
}

float draw_search_board(Sheet& sheet, const PixelBox& free) {
  const Measures& m = sheet.measures();
  const SearchShape shape = search_shape(sheet.request().shape);
  if (shape.is_on_panel && shape.has_keys_below) return 0;
  const float pad = m.gap;
  if (!shape.is_on_panel) {
    const PixelBox board = draw_board(sheet, free, shape.results + 2 * pad);
    draw_results(
        sheet, {board.x + m.margin, board.y + pad, board.width - 2 * m.margin, shape.results}, {});
    return board.height + m.gap;
  }
  const float edge = std::round(m.unit / 2);
  const KeyBoard keys = key_board(sheet, free.width - 2 * edge, free.height - 2 * pad);
  const PixelBox board = draw_board(sheet, free, keys.height() + 2 * pad);
  draw_keys(sheet, keys, {board.x + edge, board.y + pad, board.width - 2 * edge, keys.height()});
  return board.height + m.gap;
}

}  // namespace docent::interface
