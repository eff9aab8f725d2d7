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

/// The sample museum without its motion, compiled once per test program.
const std::filesystem::path& sample_database();

}  // namespace docent::test
