#include "content/import/caption/caption_text.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include "content/import/collection/utf8.h"

namespace docent::import {
namespace {

constexpr bool is_space(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\n' || c == '\f' || c == '\0';
}

/// "#233" or "#xe9" as its letter; empty where it is none.
std::string numbered(std::string_view name) {
  const bool is_hex = name.starts_with("#x") || name.starts_with("#X");
  const std::string_view digits = name.substr(is_hex ? 2 : 1);
  std::uint32_t c = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), c, is_hex ? 16 : 10);
  const bool is_letter = c >= 0x20 && c <= 0x10FFFF && (c < 0xD800 || c > 0xDFFF);
  std::string letter;
  if (error == std::errc() && end == digits.data() + digits.size() && is_letter)
    append_utf8(letter, c);
  return letter;
}

std::string letter_of(std::string_view name) {
  using Entity = std::pair<std::string_view, std::string_view>;
  // Marks of direction stay: they belong to the text.
  constexpr std::array<Entity, 8> known{{{"amp", "&"},
                                         {"lt", "<"},
                                         {"gt", ">"},
                                         {"quot", "\""},
                                         {"apos", "'"},
                                         {"nbsp", "\u00A0"},
                                         {"lrm", "\u200E"},
                                         {"rlm", "\u200F"}}};
  if (name.starts_with('#')) return numbered(name);
  for (const auto& [entity, letter] : known)
    if (entity == name) return std::string(letter);
  return {};
}

/// How long the tag is that begins here; 0 where none does.
std::size_t tag_length(std::string_view text) noexcept {
  if (text.size() < 2 || text[0] != '<') return 0;
  const char c = text[1];
  const bool begins = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '/' || c == '.' || c == '>';
  const std::size_t end = text.find_first_of("<>", 1);
  return begins && end != std::string_view::npos && text[end] == '>' ? end + 1 : 0;
}

/// Of a cue without tags and entities.
std::string without_markup(std::string_view cue) {
  constexpr std::size_t longest_entity = 10;
  std::string text;
  bool is_reading = false;  // within <rt>, the reading of ruby
  for (std::size_t at = 0; at < cue.size();) {
    const std::string_view rest = cue.substr(at);
    if (const std::size_t length = tag_length(rest); length > 0) {
      const std::string_view tag = rest.substr(0, length);
      if (tag.starts_with("<rt>") || tag.starts_with("<rt.")) is_reading = true;
      if (tag == "</rt>" || tag == "</ruby>") is_reading = false;
      at += length;
      continue;
    }
    std::size_t length = 1;
    std::string letter(1, rest[0]);
    if (const std::size_t end = rest.find(';');
        rest[0] == '&' && end != std::string_view::npos && end <= longest_entity)
      if (std::string known = letter_of(rest.substr(1, end - 1)); !known.empty()) {
        letter = std::move(known);
        length = end + 1;
      }
    if (!is_reading) text += letter;
    at += length;
  }
  return text;
}

/// Chinese and Japanese are written without spaces.
bool ends_without_space(std::string_view text) noexcept {
  if (text.size() < 3) return false;
  const auto byte = [&](std::size_t from_end) {
    return static_cast<unsigned char>(text[text.size() - from_end]);
  };
  const unsigned first = byte(3);
  if (first < 0xE2U || (first & 0xF0U) != 0xE0U) return false;
  const unsigned c = ((first & 0x0FU) << 12U) | ((byte(2) & 0x3FU) << 6U) | (byte(1) & 0x3FU);
  return (c >= 0x2E80 && c <= 0x9FFF) || (c >= 0xF900 && c <= 0xFAFF) ||
         (c >= 0xFF00 && c <= 0xFFEF);
}

bool begins_speech(std::string_view line) noexcept {
  return line.starts_with('-') || line.starts_with("\u2010") || line.starts_with("\u2013") ||
         line.starts_with("\u2014");
}

}  // namespace

std::string caption_text(std::string_view lines) {
  const std::string plain = without_markup(lines);
  std::string text;
  for (std::string_view rest = plain; !rest.empty();) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    std::string tidy;
    for (const char c : line)
      if (!is_space(c))
        tidy += c;
      else if (!tidy.empty() && tidy.back() != ' ')
        tidy += ' ';
    if (tidy.ends_with(' ')) tidy.pop_back();
    if (tidy.empty()) continue;
    if (!text.empty() && begins_speech(tidy))
      text += '\n';
    else if (!text.empty() && !ends_without_space(text))
      text += ' ';
    text += tidy;
  }
  return text;
}

}  // namespace docent::import
