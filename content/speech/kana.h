#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace docent::speech {

/// Where the dictionary of the morphological analyser MeCab, a program of its own, cannot be used:
/// an empty string where it can be.
std::string fault_of_dictionary(std::string_view told_by_mecab);

/// A whole number as it is said, in kana: 300 is サンビャク. Up to 99,999,999.
std::string number_in_kana(std::uint32_t number);

/// Japanese as it is said, in kana, for a voice that reads no kanji. `analysis`: MeCab's, for each
/// word a line of what is written, its part of speech, the kind of that, and how it is said, with
/// tabs between, and after each text a line "EOS". Words that lean on the one before are joined to
/// it; numbers are read, with the sounds that some counters change (分, 階, 月, 時). What has no
/// reading stays as it is written.
std::vector<std::string> kana_of(std::string_view analysis);

/// Asks MeCab for all of these texts at once. Throws ContentError where it or its dictionary in
/// UTF-8 is not there (Debian: mecab, mecab-ipadic-utf8), or does not answer for every text.
std::vector<std::string> read_in_kana(std::span<const std::string_view> texts,
                                      const std::string& program = "mecab");

}  // namespace docent::speech
