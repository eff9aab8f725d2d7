#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "runtime/model/diagnostic.h"
#include "runtime/model/result.h"

namespace docent::content {

/// The content compiler's one exception: a source that cannot be used, or a disk that cannot be
/// written. Thrown from wherever it is noticed, caught once per source, reported with the others.
struct ContentError : std::runtime_error {
  ContentError(std::string in_file, std::uint32_t at_line, std::uint32_t at_column,
               std::string error_code, const std::string& message, std::string with_hint = {})
      : std::runtime_error(message),
        file(std::move(in_file)),
        line(at_line),
        column(at_column),
        code(std::move(error_code)),
        hint(std::move(with_hint)) {}

  /// A failure that no author can mend in a source: its kind decides the exit code.
  ContentError(Errc error_kind, std::string in_file, std::string error_code,
               const std::string& message, std::string with_hint = {})
      : ContentError(std::move(in_file), 0, 0, std::move(error_code), message,
                     std::move(with_hint)) {
    kind = error_kind;
  }

  std::string file;          ///< The source, or the output that could not be written.
  std::uint32_t line = 0;    ///< From 1; 0 where the whole file is meant.
  std::uint32_t column = 0;  ///< From 1; 0 where the whole line is meant.
  std::string code;          ///< In kebab case: `unreadable-bvh`.
  std::string hint;          ///< What to do about it; may be empty.
  Errc kind = Errc::InvalidInput;
};

/// What an edge could not do, as the compiler reports it.
inline ContentError to_content_error(const Error& error, const std::string& file, std::string code,
                                     std::string hint = {}) {
  return {error.code, file, std::move(code), without_file(error, file), std::move(hint)};
}

inline Diagnostic to_diagnostic(const ContentError& error) {
  return {.file = error.file,
          .line = error.line,
          .column = error.column,
          .code = error.code,
          .message = error.what(),
          .hint = error.hint};
}

}  // namespace docent::content
