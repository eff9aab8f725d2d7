#pragma once

#include <string>
#include <string_view>

namespace docent::reading {

/// How a Chinese text is read: a syllable of Pinyin for each sign, without tones, with spaces
/// between them; other letters as they are, in lower case. Empty where the text has no Chinese
/// sign. Signs with several readings get their usual one. Throws ContentError where ICU has no
/// table.
std::string pinyin_of(std::string_view text);

}  // namespace docent::reading
