#include "content/command/stopwatch.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <system_error>

namespace docent::command {
namespace {

std::string words_of(std::uintmax_t bytes) {
  if (bytes < 1000) return fmt::format("{} bytes", bytes);
  const double thousands = static_cast<double>(bytes) / 1e3;
  return thousands < 1000 ? fmt::format("{:.1f} kB", thousands)
                          : fmt::format("{:.1f} MB", thousands / 1e3);
}

}  // namespace

void Stopwatch::say_wrote(const std::filesystem::path& file) const {
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began_;
  std::error_code unknown;  // a pipe has no size
  const std::uintmax_t bytes = std::filesystem::file_size(file, unknown);
  fmt::print(stderr, "wrote {}{}, in {:.1f} s\n", file.string(),
             unknown ? std::string() : fmt::format(", {}", words_of(bytes)), took.count());
}

}  // namespace docent::command
