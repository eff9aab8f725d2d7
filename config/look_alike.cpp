#include "config/look_alike.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace docent::config {

namespace {

/// Letters in a row that all stand for one, or for the ten figures.
struct Letters {
  char32_t first, last;
  std::string_view meant;
  std::string_view unseen{};  ///< What it is called, of one that is not seen.
};

constexpr std::string_view figures = "0123456789", nothing;
constexpr std::array<Letters, 43> blocks_of_letters{{
    {0x00A0, 0x00A0, " ", "a no-break space"},
    {0x1680, 0x1680, " ", "a blank of another width"},
    {0x2000, 0x200A, " ", "a blank of another width"},
    {0x202F, 0x202F, " ", "a narrow no-break space"},
    {0x205F, 0x205F, " ", "a blank of another width"},
    {0x3000, 0x3000, " ", "an ideographic space"},
    {0x00AD, 0x00AD, nothing, "a soft hyphen"},
    {0x200B, 0x200B, nothing, "a zero-width space"},
    {0x200C, 0x200D, nothing, "a zero-width joiner"},
    {0x200E, 0x200E, nothing, "a left-to-right mark"},
    {0x200F, 0x200F, nothing, "a right-to-left mark"},
    {0x061C, 0x061C, nothing, "an Arabic letter mark"},
    {0x2028, 0x2029, nothing, "a line separator"},
    {0x202A, 0x202E, nothing, "a sign that turns the direction of writing"},
    {0x2060, 0x2064, nothing, "a word joiner"},
    {0x2066, 0x2069, nothing, "a sign that turns the direction of writing"},
    {0xFEFF, 0xFEFF, nothing, "a byte order mark"},
    {0x2010, 0x2015, "-"},
    {0x2212, 0x2212, "-"},
    {0xFE63, 0xFE63, "-"},
    {0xFF0D, 0xFF0D, "-"},
    {0x2018, 0x201F, "\""},
    {0x00AB, 0x00AB, "\""},
    {0x00BB, 0x00BB, "\""},
    {0x2032, 0x2033, "\""},
    {0x300C, 0x300F, "\""},
    {0x301D, 0x301F, "\""},
    {0xFF02, 0xFF02, "\""},
    {0xFF07, 0xFF07, "'"},
    {0x060C, 0x060C, ","},
    {0x3001, 0x3001, ","},
    {0xFF0C, 0xFF0C, ","},
    {0x066B, 0x066B, "."},
    {0x3002, 0x3002, "."},
    {0xFF0E, 0xFF0E, "."},
    {0xFF1D, 0xFF1D, "="},
    {0xFF1A, 0xFF1A, "="},
    {0x0660, 0x0669, figures},
    {0x06F0, 0x06F9, figures},
    {0x0966, 0x096F, figures},
    {0x0E50, 0x0E59, figures},
    {0xFF10, 0xFF19, figures},
    {0xFF03, 0xFF03, "#"},
}};
/// Opening brackets and the closing ones behind them.
constexpr std::array<Letters, 4> brackets{
    {{0xFF3B, 0xFF3B, "["}, {0xFF3D, 0xFF3D, "]"}, {0x3010, 0x3010, "["}, {0x3011, 0x3011, "]"}}};

LookAlike found(const Letters& block, char32_t letter, std::string_view character) {
  const auto number = static_cast<std::uint32_t>(letter);
  if (!block.unseen.empty())
    return {fmt::format("{} (U+{:04X})", block.unseen, number), block.meant, false};
  const bool is_figure = block.meant == figures;
  return {fmt::format("'{}' (U+{:04X})", character, number),
          is_figure ? block.meant.substr(letter - block.first, 1) : block.meant};
}

}  // namespace

std::string_view first_character_of(std::string_view text) noexcept {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t size = first < 0xC0 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  return text.substr(0, size);
}

char32_t letter_of(std::string_view character) noexcept {
  const auto first = static_cast<unsigned char>(character.front());
  if (character.size() == 1) return first;
  char32_t letter = first & (0xFFU >> (character.size() + 1));
  for (const char c : character.substr(1))
    letter = (letter << 6U) | (static_cast<unsigned char>(c) & 0x3FU);
  return letter;
}

std::optional<LookAlike> look_alike(std::string_view character) {
  if (character.size() < 2) return {};
  const char32_t letter = letter_of(character);
  for (const Letters& block : blocks_of_letters)
    if (letter >= block.first && letter <= block.last) return found(block, letter, character);
  for (const Letters& block : brackets)
    if (letter == block.first) return found(block, letter, character);
  return {};
}

std::optional<LookAlike> unseen_character(std::string_view text) {
  while (!text.empty()) {
    const std::string_view character = first_character_of(text);
    if (auto found = look_alike(character); found && !found->is_seen) return found;
    text.remove_prefix(character.size());
  }
  return {};
}

}  // namespace docent::config
