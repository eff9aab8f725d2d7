#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "config/toml_document.h"

namespace docent::config {

/// Why a file is no TOML, as its author has to hear it.
struct TomlFault {
  SourceRange range;    ///< Where the mistake was made, which may be lines before it was noticed.
  std::string message;  ///< A sentence without its subject: "the text that begins here ...".
  std::string hint;     ///< What to write instead.
};

/// Explains what a parser stumbled over. `noticed` is the parser's place; `redefines` where it
/// complains that something is written twice. Defined for any bytes.
TomlFault explain_toml_fault(std::string_view text, SourceRange noticed, bool redefines);

}  // namespace docent::config
