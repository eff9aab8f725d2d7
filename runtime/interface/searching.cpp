/// The screen on which a visitor types, and sees what is found.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "runtime/interface/face.h"
#include "runtime/interface/finder.h"
#include "runtime/interface/keyboard.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/phrases.h"
#include "runtime/search/compose.h"

namespace docent::interface {
namespace {

/// The keys that type no letter, on the last row, and how many letters' keys each is as wide as.
struct WideKey {
  std::string_view name;
  float least;  ///< What they leave goes to the space.
};
constexpr std::array wide_keys{WideKey{"key:numbers", 2}, WideKey{"key:space", 2},
                               WideKey{"key:erase", 2}, WideKey{"key:clear", 2}};
constexpr float wide_cells = 8;

std::string_view read_in(const Museum& museum, std::uint32_t language) noexcept {
  return language < museum.languages.size() ? std::string_view(museum.languages[language].tag)
                                            : std::string_view("en");
}

/// How large keys are and how far apart, in pixels.
struct KeySizes {
  float least = 54, most_wide = 90, most_tall = 80, gap = 11;
};
KeySizes key_sizes(const ScreenShape& shape) noexcept {
  constexpr float finger = 15, apart = 3, widest = 24;  // millimetres
  const float tallest = is_landscape(shape) ? 19 : 26;
  const Measures m = measures_of(shape);
  const float least = std::ceil(std::max(finger * m.mm, 7 * m.unit));
  // A large glass is looked at from farther off.
  return {.least = least,
          .most_wide = std::floor(std::max(widest * m.mm, 1.5F * least)),
          .most_tall = std::floor(std::max(tallest * m.mm, 1.15F * least)),
          .gap = std::ceil(apart * m.mm)};
}

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

/// What a visitor has typed, or what they can type.
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
  const TextPiece piece = sheet.set(style, text, width - m.unit);
  sheet.piece(piece, x, box.y + (box.height - piece.height) / 2, width, Align::Start,
              is_empty ? sheet.theme().quiet_ink : sheet.theme().ink);
  if (is_empty || piece.lines > 1) return;
  const float caret = std::max(2.0F, std::round(0.3F * m.unit)),
              tall = std::round(0.56F * box.height);
  sheet.fill({std::round(x + piece.width + caret), std::round(box.y + (box.height - tall) / 2),
              caret, tall},
             sheet.theme().ink, 0);
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
  if (!state.found.is_current || (is_open && state.found.total == 0)) return;
  if (is_open && has_pages) return;  // there is no room to say what the list is; it says so itself
  const std::string text = is_open ? std::string(sheet.word("search_browse"))
                           : state.found.total == 0
                               ? std::string(sheet.word("search_none"))
                               : filled_in(sheet.word("search_found"), "n",
                                           number_in(sheet.museum(), state.language,
                                                     static_cast<long>(state.found.total)));
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

/// One line of keys: controls, and how many cells each takes.
struct KeyRow {
  std::vector<std::pair<std::int32_t, float>> keys;
  float cells = 0;

  void add(std::int32_t control, float wide) {
    keys.emplace_back(control, wide);
    cells += wide;
  }
};

std::vector<std::u16string_view> letter_rows(const Museum& museum, const InterfaceState& state) {
  if (state.types_numbers) return {digit_keys};
  const Keyboard& keyboard = keyboard_of(read_in(museum, state.language));
  return {keyboard.rows.begin(),
          keyboard.rows.begin() + static_cast<std::ptrdiff_t>(keyboard.row_count())};
}

std::string key_name(char16_t letter) {
  return "key:" + search::utf8_of(letter);
}

/// Rows as people know them.
std::vector<KeyRow> rows_as_known(const Sheet& sheet) {
  std::vector<KeyRow> rows;
  float widest = wide_cells;
  for (const std::u16string_view letters : letter_rows(sheet.museum(), sheet.request().state)) {
    KeyRow& row = rows.emplace_back();
    for (const char16_t letter : letters) row.add(sheet.control(key_name(letter)), 1);
    widest = std::max(widest, row.cells);
  }
  KeyRow& last = rows.emplace_back();
  for (const WideKey& key : wide_keys)
    last.add(sheet.control(key.name),
             key.name == "key:space" ? key.least + widest - wide_cells : key.least);
  return rows;
}

/// The same keys in at most so many lines of so many, where there is no room for the rows: letters
/// in lines of one length, and the wide keys below them, or after them where there is no room.
std::vector<KeyRow> rows_of(const Sheet& sheet, float most_columns, float most_lines) {
  std::vector<std::int32_t> letters;
  for (const std::u16string_view row : letter_rows(sheet.museum(), sheet.request().state))
    for (const char16_t letter : row) letters.push_back(sheet.control(key_name(letter)));
  const auto count = static_cast<float>(letters.size());
  const float lines = std::ceil(count / most_columns);
  const bool has_last = lines + 1 <= most_lines;
  const float columns = has_last ? std::max(wide_cells, std::ceil(count / lines)) : most_columns;
  std::vector<KeyRow> rows(1);
  const auto add = [&](std::int32_t control, float wide) {
    if (rows.back().cells + wide > columns) rows.emplace_back();
    rows.back().add(control, wide);
  };
  for (const std::int32_t letter : letters) add(letter, 1);
  if (has_last) rows.emplace_back();
  for (const WideKey& key : wide_keys) add(sheet.control(key.name), key.least);
  return rows;
}

float widest_of(const std::vector<KeyRow>& rows) noexcept {
  float widest = 1;
  for (const KeyRow& row : rows) widest = std::max(widest, row.cells);
  return widest;
}

/// The rows that fit into so much room, and the size of a letter's key on them.
struct KeyBoard {
  std::vector<KeyRow> rows;
  float wide = 0, tall = 0, gap = 0;

  float height() const noexcept { return static_cast<float>(rows.size()) * (tall + gap) - gap; }
};
KeyBoard key_board(const Sheet& sheet, float width, float height) {
  const KeySizes sizes = key_sizes(sheet.request().shape);
  KeyBoard board{.rows = rows_as_known(sheet), .gap = sizes.gap};
  const auto size = [&](float room, float count) {
    return std::floor((room + board.gap) / count - board.gap);
  };
  const auto fit = [&] {
    board.wide = std::min(sizes.most_wide, size(width, widest_of(board.rows)));
    board.tall = std::min(sizes.most_tall, size(height, static_cast<float>(board.rows.size())));
    return board.wide >= sizes.least && board.tall >= sizes.least;
  };
  if (fit()) return board;
  board.rows = rows_of(sheet, std::floor((width + board.gap) / (sizes.least + board.gap)),
                       std::floor((height + board.gap) / (sizes.least + board.gap)));
  fit();
  board.wide = std::max(board.wide, sizes.least);
  board.tall = std::max(board.tall, sizes.least);
  return board;
}

void draw_key(Sheet& sheet, std::int32_t control, const PixelBox& box) {
  if (control < 0) return;
  sheet.place(control, box);
  const Control& it = sheet.view().controls[static_cast<std::size_t>(control)];
  const bool is_letter = it.action.kind == Action::Kind::Type && it.action.argument != U' ';
  sheet.fill(box, sheet.theme().plaster, sheet.measures().corner, control);
  sheet.outline(box, control);
  TextStyle style = sheet.style(is_letter ? Letters::Label : Letters::Small);
  constexpr float most = 0.62F;  // of the key
  style.size = std::min(style.size, std::floor(most * box.height));
  style.line_height = std::min(style.line_height, std::floor(box.height) / style.size);
  const float pad = is_letter ? 0 : std::round(sheet.measures().unit / 2);
  const float width = box.width - 2 * pad;
  const float longest = sheet.longest_word(style, sheet.local(it.label));
  // A key is as wide as its row leaves it, and its word is known by its place.
  if (longest > width) style.size = std::floor(style.size * width / longest);
  const TextPiece label = sheet.set(style, sheet.local(it.label), width);
  const scene::Colour colour =
      it.enabled ? sheet.theme().ink : scene::with_opacity(sheet.theme().quiet_ink, 0.35F);
  sheet.piece(label, box.x + pad, box.y + (box.height - label.height) / 2, box.width - 2 * pad,
              Align::Centre, colour, control);
}

/// Every keyboard runs from left to right: where the language does not, the sheet is turned over
/// afterwards, and so is this.
void draw_keys(Sheet& sheet, const KeyBoard& board, const PixelBox& box) {
  const bool is_turned = runs_right_to_left(sheet.museum(), sheet.request().state.language);
  float y = box.y;
  for (const KeyRow& row : board.rows) {
    float x = std::round((box.width - row.cells * (board.wide + board.gap) + board.gap) / 2);
    for (const auto& [control, cells] : row.keys) {
      const float wide = cells * (board.wide + board.gap) - board.gap;
      draw_key(sheet, control,
               {is_turned ? box.right() - x - wide : box.x + x, y, wide, board.tall});
      x += wide + board.gap;
    }
    y += board.tall + board.gap;
  }
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

bool is_key(const Control& control) noexcept {
  switch (control.action.kind) {
    case Action::Kind::Type:
    case Action::Kind::Erase:
    case Action::Kind::Clear:
    case Action::Kind::TypeNumbers:
      return true;
    default:
      return false;
  }
}

void add_keys(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  const std::string tag(read_in(museum, state.language));
  for (const std::u16string_view row : letter_rows(museum, state))
    for (const char16_t letter : row) {
      const bool is_digit = letter >= u'0' && letter <= u'9';
      const std::string label =
          is_digit ? number_in(museum, state.language, letter - u'0') : label_of(letter);
      out.push_back({.name = key_name(letter),
                     .label = {{tag, label}},
                     .action = {Action::Kind::Type, letter},
                     .enabled = !state.typed.is_full(),
                     .rect = {}});
    }
  const bool numbers = state.types_numbers;
  out.push_back(button(museum, "key:numbers", numbers ? "key_letters" : "key_digits",
                       {Action::Kind::TypeNumbers, numbers ? 0U : 1U}));
  out.push_back(button(museum, "key:space", "key_space", {Action::Kind::Type, U' '}));
  out.push_back(button(museum, "key:erase", "key_erase", {Action::Kind::Erase}));
  out.push_back(button(museum, "key:clear", "key_clear", {Action::Kind::Clear}));
  out[out.size() - 2].enabled = state.typed.count > 0;
  out.back().enabled = state.typed.count > 0 || state.browses;
}

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
