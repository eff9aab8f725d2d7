#include "config/text_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "config/letters.h"
#include "config/look_alike.h"
#include "config/shown_letters.h"
#include "platform/file/text_encoding.h"

namespace docent::config {

namespace {

struct Block {
  char32_t first, last;
  std::string_view name, hint;
};

constexpr std::string_view say_it = "say it in words; the kiosk's fonts hold letters, no pictures";
constexpr std::string_view type_again = "delete it and type the text again";
constexpr std::array<Block, 11> unshown{{
    {0x00, 0x08, "the control character", type_again},
    {0x0B, 0x0C, "the control character", type_again},
    {0x0E, 0x1F, "the control character", type_again},
    {0x7F, 0x9F, "the control character", type_again},
    {0x2600, 0x26FF, "the emoji", say_it},
    {0x2700, 0x27BF, "the emoji", say_it},
    {0xFE0F, 0xFE0F, "the sign that makes an emoji,", say_it},
    {0xE000, 0xF8FF, "the letter of private use",
     "only the font it was written in knows what it is"},
    {0xFFFD, 0xFFFD, "the mark of a lost letter,",
     "the file was saved in a wrong encoding: type the "
     "letter again"},
    {0x1F000, 0x1FAFF, "the emoji", say_it},
    {0xF0000, 0x10FFFF, "the letter of private use",
     "only the font it was written in knows what it "
     "is"},
}};

/// Takes one code point off valid UTF-8; bytes that are none stand for themselves.
char32_t take_letter(std::string_view& text) {
  const std::string_view character = first_character_of(text);
  text.remove_prefix(character.size());
  return letter_of(character);
}

/// What the bytes 0x80 to 0x9F are in Windows-1252.
constexpr std::array<char32_t, 32> windows_1252{
    0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

bool is_high(char c) {
  return (static_cast<unsigned char>(c) & 0x80U) != 0;
}

/// How many bytes at the beginning of a text are no ASCII.
std::size_t run_of_high(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::find_if_not(text, is_high) - text.begin());
}

/// Characters as bytes of Windows-1252; empty where one is none of them.
std::string as_windows_1252(std::string_view text) {
  std::string bytes;
  while (!text.empty()) {
    const char32_t letter = take_letter(text);
    const auto low = std::ranges::find(windows_1252, letter);
    if (low != windows_1252.end())
      bytes += static_cast<char>(0x80 + (low - windows_1252.begin()));
    else if (letter >= 0xA0 && letter <= 0xFF)
      bytes += static_cast<char>(letter);
    else
      return {};
  }
  return bytes;
}

std::size_t letters_in(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// A tag or an entity of HTML: "<b>", "&amp;". Empty where there is none.
std::string_view markup_in(std::string_view text) {
  constexpr std::size_t longest = 80;
  for (std::size_t at = text.find_first_of("<&"); at != std::string_view::npos;
       at = text.find_first_of("<&", at + 1)) {
    const bool is_tag = text[at] == '<';
    std::size_t name = at + 1;
    if (name < text.size() && text[name] == (is_tag ? '/' : '#')) ++name;
    const std::size_t end = text.find(is_tag ? '>' : ';', name);
    if (end == std::string_view::npos || end - at > longest || end == name) continue;
    const std::string_view inside = text.substr(name, end - name);
    const bool plain =
        std::ranges::all_of(inside, [](char c) { return is_letter(c) || is_digit(c); });
    if (is_tag ? is_letter(inside.front()) && inside.find('<') == std::string_view::npos
               : plain && inside.size() <= 8)
      return text.substr(at, end + 1 - at);
  }
  return {};
}

/// Question marks in place of every letter.
bool is_lost(std::string_view text) {
  return std::ranges::count(text, '?') >= 3 &&
         text.find_first_not_of("? .,:;!-\n") == std::string_view::npos;
}

bool is_name(std::string_view text) {
  return !text.empty() && text.find_first_not_of(
                              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789") ==
                              std::string_view::npos;
}

}  // namespace

std::optional<UnshownLetter> unshown_letter(std::string_view text, Fonts fonts) {
  constexpr Block missing{0, 0, "the letter",
                          "write it otherwise, or name fonts that have it: [look] text_font"};
  while (!text.empty()) {
    const char32_t letter = take_letter(text);
    const auto* block = std::ranges::find_if(unshown, [letter](const Block& each) {
      return letter >= each.first && letter <= each.last;
    });
    if (block == unshown.end() && (fonts == Fonts::Own || letter == '\n' || letter == '\r' ||
                                   letter == '\t' || is_shown(letter)))
      continue;
    if (block == unshown.end()) block = &missing;
    return UnshownLetter{fmt::format("{} U+{:04X}", block->name, std::uint32_t{letter}),
                         std::string(block->hint)};
  }
  return {};
}

std::string before_wrong_encoding(std::string_view text) {
  std::string before;
  std::size_t letters = 0;
  bool is_typical = false;
  while (!text.empty()) {
    const std::size_t high = run_of_high(text);
    if (high == 0) {
      before += text.front();
      text.remove_prefix(1);
      continue;
    }
    const std::string_view run = text.substr(0, high);
    const std::string bytes = as_windows_1252(run);
    if (bytes.empty() || file::encoding_fault(bytes)) return {};
    is_typical = is_typical || run.starts_with("Ã") || run.starts_with("â€");
    letters += letters_in(bytes);
    before += bytes;
    text.remove_prefix(high);
  }
  constexpr std::size_t enough = 3;  // one such pair may be a capital before a quotation mark
  return letters >= enough || (letters > 0 && is_typical) ? before : "";
}

std::size_t room_of(std::string_view text) {
  constexpr std::size_t line = 40;  // letters: the narrower of the two screens' columns
  std::size_t room = 0, of_line = 0;
  while (!text.empty()) {
    const char32_t letter = take_letter(text);
    const bool is_mark =
        (letter >= 0x300 && letter <= 0x36F) || (letter >= 0x64B && letter <= 0x65F);
    const bool is_wide =
        letter >= 0x2E80 && letter <= 0xFFEF && (letter < 0xFB00 || letter > 0xFEFF);
    if (letter != '\n') {
      of_line += is_mark ? 0 : is_wide ? 2 : 1;
      continue;
    }
    room += std::max<std::size_t>(1, (of_line + line - 1) / line) * line;
    of_line = 0;
  }
  return room + of_line;
}

std::vector<TextFault> faults_of(std::string_view text, Fonts fonts, std::size_t room) {
  std::vector<TextFault> faults;
  if (const auto letter = unshown_letter(text, fonts))
    faults.push_back({"unshown-letter", "holds " + letter->name,
                      ", which a kiosk has no letters for", letter->hint});
  if (const std::string_view tag = markup_in(text); !tag.empty())
    faults.push_back({"markup", fmt::format("holds '{}'", tag),
                      ", and visitors see it as it is written",
                      "write plain words: a kiosk knows no HTML"});
  if (const std::string before = before_wrong_encoding(text); !before.empty())
    faults.push_back({"wrong-letters", "has the letters of a wrong encoding", "",
                      fmt::format("it was: {}", before)});
  if (is_lost(text))
    faults.push_back(
        {"lost-letters", "is nothing but question marks", "",
         "its letters were lost where it was saved in another encoding: type it again"});
  if (const std::size_t taken = room_of(text); taken > room)
    faults.push_back(
        {"text-does-not-fit", "does not fit on a screen",
         fmt::format(", and visitors have to scroll: it takes the room of {} letters", taken),
         fmt::format("who reads on the way reads {} letters (half as many Chinese ones), in few "
                     "lines",
                     room)});
  return faults;
}

std::set<std::string> placeholders_of(std::string_view text) {
  std::set<std::string> names;
  for (std::size_t open = text.find('{'); open != std::string_view::npos;
       open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    if (close == std::string_view::npos) break;
    if (is_name(text.substr(open + 1, close - open - 1)))
      names.emplace(text.substr(open, close - open + 1));
  }
  return names;
}

}  // namespace docent::config
