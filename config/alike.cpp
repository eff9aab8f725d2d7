#include "config/alike.h"

#include <fmt/format.h>

#include <map>
#include <string>

#include "config/letters.h"

namespace docent::config {

namespace {

constexpr std::size_t most_alike = 5, shown_of_more = 3;

/// What a diagnostic says, without what is said only of this one thing.
std::string kind_of(const Diagnostic& diagnostic) {
  std::string kind = diagnostic.code + (diagnostic.severity == Severity::Error ? "!" : "?");
  bool quoted = false;
  for (const char c : diagnostic.message) {
    if (c == '\'') quoted = !quoted;
    if (!quoted && !is_digit(c)) kind += c;
  }
  return kind;
}

}  // namespace

std::vector<Diagnostic> without_alike(std::span<const Diagnostic> diagnostics) {
  std::map<std::string, std::size_t> count, told;
  for (const Diagnostic& diagnostic : diagnostics) ++count[kind_of(diagnostic)];
  std::vector<Diagnostic> fewer;
  for (const Diagnostic& diagnostic : diagnostics) {
    const std::string kind = kind_of(diagnostic);
    const std::size_t number = ++told[kind], all = count[kind];
    if (all > most_alike && number > shown_of_more) continue;
    fewer.push_back(diagnostic);
    if (all > most_alike && number == shown_of_more)
      fewer.back().hint +=
          fmt::format("{}and {} more like this; all of them with --json",
                      fewer.back().hint.empty() ? "" : "\n         ", all - shown_of_more);
  }
  return fewer;
}

}  // namespace docent::config
