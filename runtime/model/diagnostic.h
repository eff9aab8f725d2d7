#pragma once

#include <cstdint>
#include <string>

namespace docent {

enum class Severity : std::uint8_t { Error, Warning };

/// One mistake in something that people wrote, as it is shown to them.
struct Diagnostic {
  std::string file{};        ///< As the author named it, so that an editor can open it.
  std::uint32_t line = 0;    ///< From 1; 0 where the problem is the whole file.
  std::uint32_t column = 0;  ///< From 1, in characters; 0 where the problem is the whole line.
  std::uint32_t length = 1;  ///< Characters to underline from `column`.
  Severity severity = Severity::Error;
  std::string code{};     ///< Stable, in kebab case: `missing-file`.
  std::string message{};  ///< A sentence without a full stop.
  std::string label{};    ///< A few words beside the underlined characters; may be empty.
  std::string hint{};     ///< What to do about it; may be empty.
};

}  // namespace docent
