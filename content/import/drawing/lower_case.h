#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace docent::import {

/// The text with its Latin letters small, whatever the locale; others stay.
inline std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

}  // namespace docent::import
