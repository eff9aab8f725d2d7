#pragma once

#include <chrono>
#include <filesystem>

namespace docent::command {

/// Runs from when a command begins, so that it can say how long it took.
class Stopwatch {
 public:
  /// One line on standard error: what was written, how large it is and how long that took.
  void say_wrote(const std::filesystem::path& file) const;

 private:
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace docent::command
