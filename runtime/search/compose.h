#pragma once

#include <string>
#include <string_view>

namespace docent::search {

/// What somebody who presses one key a letter expects to read, in UTF-8: jamo as syllables of
/// Hangul, a vowel of Devanagari after a consonant as its sign, kana with the voicing mark that
/// follows. All else as it was typed.
std::string composed(std::u16string_view typed);

/// One letter in UTF-8.
std::string utf8_of(char16_t letter);

}  // namespace docent::search
