#pragma once

#include <string>
#include <string_view>

namespace docent::import {

/// A text as UTF-8, without a byte order mark, and what its bytes were.
struct DecodedText {
  std::string text;
  std::string encoding;  ///< "UTF-8", "UTF-16", "Windows-1252".
};

/// Takes bytes as the encoding that is named (its letter case and hyphens are left out of
/// account); where none is, or none that is known, as what they seem: UTF-16 by its mark, UTF-8
/// where they are, else Windows-1252. Any bytes are answered.
DecodedText decode_text(std::string_view bytes, std::string_view encoding = {});

}  // namespace docent::import
