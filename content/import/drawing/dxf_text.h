#pragma once

#include <string>
#include <string_view>

namespace docent::import {

/// A TEXT without its control codes: `%%d` is a degree sign, `\U+00e9` an é.
std::string without_controls(std::string_view text);

/// An MTEXT without its formatting: `{\fArial|b1;A002}\P71.25 m{\H0.7x;\S2^;}` is "A002\n71.25 m2".
std::string without_formatting(std::string_view text);

struct TextExtent {
  int columns = 0;  ///< Letters of the longest line.
  int lines = 0;
};
TextExtent extent_of(std::string_view text);

}  // namespace docent::import
