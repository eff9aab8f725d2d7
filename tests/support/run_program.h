#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

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

/// Speech takes seconds, and few tests listen: a museum is compiled without it where --speech is
/// not asked for.
inline std::string with_speech_or_without(const char* name, const std::string& arguments) {
  const bool is_compilation =
      std::string_view(name) == "docent-content" && arguments.starts_with("compile ");
  const bool is_to_speak = arguments.find("--speech") != std::string::npos;
  return is_compilation && !is_to_speak ? arguments + " --no-speech" : arguments;
}

/// Runs one of our programs with arguments as a shell takes them.
inline ProgramRun run_program(const char* name, const std::string& given_arguments) {
  const std::string arguments = with_speech_or_without(name, given_arguments);
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
