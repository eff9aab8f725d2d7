#pragma once

#include <array>
#include <random>
#include <string>

namespace docent::test {

/// How many scripts there are to make titles in.
inline constexpr int made_scripts = 5;

/// Words of letters that look like a language's.
inline std::string made_title(std::mt19937& random, int script) {
  constexpr std::array<std::array<int, 2>, made_scripts> ranges{
      {{'a', 'z'}, {0x430, 0x44F}, {0x627, 0x64A}, {0xAC00, 0xD7A3}, {0x4E00, 0x9FA5}}};
  const auto [first, last] = ranges[static_cast<std::size_t>(script)];
  std::string text;
  const auto number = [&](int least, int most) {
    return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
  };
  const int words = number(2, 5);
  for (int w = 0; w < words; ++w) {
    if (w > 0) text += ' ';
    for (int i = number(2, script > 2 ? 3 : 9); i > 0; --i) {
      const int c = number(first, last);
      if (c < 0x80) {
        text += static_cast<char>(c);
      } else if (c < 0x800) {
        text += static_cast<char>(0xC0 | c >> 6);
        text += static_cast<char>(0x80 | (c & 0x3F));
      } else {
        text += static_cast<char>(0xE0 | c >> 12);
        text += static_cast<char>(0x80 | (c >> 6 & 0x3F));
        text += static_cast<char>(0x80 | (c & 0x3F));
      }
    }
  }
  return text;
}

}  // namespace docent::test
