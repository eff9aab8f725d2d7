#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace docent {

/// The most letters of a longer text (Exhibit::more) in a language: nobody reads more of it
/// standing, and a kiosk sets and keeps all of it.
inline constexpr std::size_t longest_more = 20'000;

/// How many letters a text (UTF-8) has; of bytes that are no text at least one for every four.
inline std::size_t count_letters(std::string_view text) noexcept {
  const auto begins_letter = [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  };
  const auto letters = static_cast<std::size_t>(std::ranges::count_if(text, begins_letter));
  return std::max(letters, (text.size() + 3) / 4);
}

}  // namespace docent
