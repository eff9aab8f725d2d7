#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "platform/terminal/colour.h"
#include "runtime/model/diagnostic.h"

namespace docent::config {

/// A diagnostic as people read it, with its line of the source and carets under what is meant:
///
///     exhibits/bronze.toml:14:12: error[exhibit-outside-floor]: exhibit 'tripod' stands outside
///        14 | position = [12.40, 3.10]
///           |            ^^^^^^^^^^^^^ 0.18 m outside the floor of 'ground'
///        hint: the nearest free point is [12.40, 3.45]
///
/// Ends with a line feed. Reads the source again; a line that is no longer there is left out.
std::string to_text(const Diagnostic& diagnostic,
                    terminal::ColourUse colour = terminal::ColourUse::Off);

/// The same as one JSON object on one line: file line column code severity message hint.
std::string to_json(const Diagnostic& diagnostic);

enum class DiagnosticForm : std::uint8_t { Text, Json };

/// Writes diagnostics to standard error. A terminal sees the first 20 as text and then the count.
void tell(std::span<const Diagnostic> diagnostics, DiagnosticForm form = DiagnosticForm::Text);

}  // namespace docent::config
