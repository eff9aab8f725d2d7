#include "content/compile/report.h"

#include <algorithm>
#include <tuple>

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

}  // namespace docent::compile
