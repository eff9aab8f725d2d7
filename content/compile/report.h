#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

#include "runtime/model/diagnostic.h"

namespace docent::compile {

/// Everything that a run found wrong, told at its end in the order of the sources. Any thread may
/// add.
class Report {
 public:
  void add(Diagnostic diagnostic);
  void add(const std::vector<Diagnostic>& diagnostics);

  /// Names the sources in the order in which they are to be told of; others follow by name.
  void set_file_order(std::vector<std::string> files);

  [[nodiscard]] bool has_errors() const;

  /// All of it, as it is to be told.
  [[nodiscard]] std::vector<Diagnostic> in_order() const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> files_;
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace docent::compile
