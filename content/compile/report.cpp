#include "content/compile/report.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <tuple>

#include "config/diagnostic_text.h"

namespace docent::compile {

void Report::add(Diagnostic diagnostic) {
  const std::lock_guard lock(mutex_);
  diagnostics_.push_back(std::move(diagnostic));
}

void Report::add(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) add(diagnostic);
}

void Report::set_file_order(std::vector<std::string> files) {
  const std::lock_guard lock(mutex_);
  files_ = std::move(files);
}

bool Report::has_errors() const {
  const std::lock_guard lock(mutex_);
  return std::ranges::any_of(diagnostics_,
                             [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

std::vector<Diagnostic> Report::in_order() const {
  const std::lock_guard lock(mutex_);
  std::vector<Diagnostic> sorted = diagnostics_;
  std::ranges::stable_sort(sorted, {}, [&](const Diagnostic& d) {
    return std::tuple(std::ranges::find(files_, d.file) - files_.begin(), d.file, d.line, d.column);
  });
  return sorted;
}

void Report::print(Form form) const {
  constexpr std::size_t terminal_limit = 20;
  const std::vector<Diagnostic> sorted = in_order();
  const bool shortens = form == Form::Text && ::isatty(STDERR_FILENO) == 1;
  const std::size_t shown = shortens ? std::min(sorted.size(), terminal_limit) : sorted.size();
  for (std::size_t i = 0; i < shown; ++i)
    fmt::print(stderr, "{}",
               form == Form::Json ? config::to_json(sorted[i]) + "\n" : config::to_text(sorted[i]));
  if (shown < sorted.size())
    fmt::print(stderr, "... and {} more; all of them with 2>FILE\n", sorted.size() - shown);
}

}  // namespace docent::compile
