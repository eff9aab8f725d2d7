#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace docent::test {

/// What a program did.
struct Outcome {
  int exit_code = -1;
  std::string out, err;
};

/// Runs a command to its end.
Outcome run(const std::filesystem::path& program, const std::vector<std::string>& arguments);

std::string read_file(const std::filesystem::path& file);
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace docent::test
