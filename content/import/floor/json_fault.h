#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace docent::import {

/// Why a text is no JSON, as its author has to hear it.
struct JsonFault {
  std::size_t offset = 0;  ///< Byte at which the mistake was made.
  std::string message;     ///< A sentence.
  std::string hint;
};

/// Explains what a parser stumbled over at a byte of a text. Any bytes are answered.
JsonFault explain_json_fault(std::string_view text, std::size_t offset);

}  // namespace docent::import
