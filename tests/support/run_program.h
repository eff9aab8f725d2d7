#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/reference_data.h"
#include "tests/support/temporary_folder.h"

namespace docent::test {

/// What a program said and how it ended.
struct ProgramRun {
  int exit_code = -1;  ///< -1 where it was killed.
  std::string out, err;
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Runs one of our programs with arguments as a shell takes them.
inline ProgramRun run_program(const char* name, const std::string& arguments) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string err = (folder.path() / "err").string();
  const std::string command =
      "'" + program(name).string() + "' " + arguments + " >'" + out + "' 2>'" + err + "'";
  const int status = std::system(command.c_str());  // NOLINT(bugprone-command-processor)
  return {.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          .out = text_of(out),
          .err = text_of(err)};
}

}  // namespace docent::test
