#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace docent::search {

/// What a letter is compared by: without case, accents, points, width and length; Hangul by the
/// keys that one presses for it, kana as plain hiragana. Nothing for what is left out, a space for
/// what stands between words. Folding what is folded changes nothing.
struct Folded {
  std::array<char16_t, 6> letters{};
  std::uint8_t count = 0;
};
Folded fold(char32_t letter) noexcept;

/// A text, and letters as they are typed, folded: words with one space between them.
std::u16string folded(std::string_view text);
std::u16string folded(std::u16string_view typed);

/// Appends folded letters; no space at the beginning, and no two beside each other.
void append(std::u16string& out, const Folded& letters);
/// Without the space at the end.
std::u16string trimmed(std::u16string text);

/// The first letter of a UTF-8 text that is not empty, and how many bytes it takes. What is no
/// UTF-8 is U+FFFD.
struct Decoded {
  char32_t letter;
  std::size_t length;
};
Decoded decode(std::string_view text) noexcept;

/// Is it a syllable of Hangul?
inline constexpr char32_t first_syllable = U'\uAC00', last_syllable = U'\uD7A3';
constexpr bool is_syllable(char32_t letter) noexcept {
  return letter >= first_syllable && letter <= last_syllable;
}

}  // namespace docent::search
