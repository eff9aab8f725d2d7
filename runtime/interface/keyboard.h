#pragma once

#include <array>
#include <string>
#include <string_view>

namespace docent::interface {

/// The keys that a visitor searches with: one a letter, as people who write the language know them.
/// Marks that a search leaves out anyway, such as accents, have no keys.
struct Keyboard {
  std::string_view language;  ///< BCP 47, the language alone.
  /// From the left; for languages that run from right to left, too. Rows at the end may be empty.
  std::array<std::u16string_view, 6> rows;

  std::size_t row_count() const noexcept;
};

/// Chinese is typed in Pinyin; a language without a keyboard of its own gets that of English.
const Keyboard& keyboard_of(std::string_view tag) noexcept;
/// The keys of numbers, whatever the language.
inline constexpr std::u16string_view digit_keys = u"1234567890";

/// What stands on a key, and what it is called when it is said.
std::string label_of(char16_t letter);
std::string said_of(char16_t letter);

}  // namespace docent::interface
