#include "runtime/interface/key_board.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "runtime/interface/face.h"
#include "runtime/interface/keyboard.h"
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
  const float columns = has_last
                            ? std::min(most_columns, std::max(wide_cells, std::ceil(count / lines)))
                            : most_columns;
  std::vector<KeyRow> rows(1);
  const auto add = [&](std::int32_t control, float wide) {
    if (rows.back().cells + wide > columns) rows.emplace_back();
    rows.back().add(control, wide);
  };
  for (const std::int32_t letter : letters) add(letter, 1);
  if (has_last) rows.emplace_back();
  // Beside each other where that leaves each enough for its word.
  constexpr float least_cells = 1.5F, count_of_wide = wide_keys.size();
  const float beside = columns / count_of_wide;
  const bool are_beside = has_last && columns < wide_cells && beside >= least_cells;
  for (const WideKey& key : wide_keys)
    add(sheet.control(key.name), are_beside ? beside : key.least);
  return rows;
}

float widest_of(const std::vector<KeyRow>& rows) noexcept {
  float widest = 1;
  for (const KeyRow& row : rows) widest = std::max(widest, row.cells);
  return widest;
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
  const float height = sheet.height_of(style, sheet.local(it.label), width);
  if (height > box.height) style.size = std::floor(style.size * box.height / height);
  const TextPiece label = sheet.set(style, sheet.local(it.label), width);
  const scene::Colour colour =
      it.enabled ? sheet.theme().ink : scene::with_opacity(sheet.theme().quiet_ink, 0.35F);
  sheet.piece(label, box.x + pad, box.y + (box.height - label.height) / 2, box.width - 2 * pad,
              Align::Centre, colour, control);
}

}  // namespace

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

}  // namespace docent::interface
