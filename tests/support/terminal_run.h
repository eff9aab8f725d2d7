#pragma once

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "tests/support/reference_data.h"

namespace docent::test {

/// Runs one of our programs as somebody at a terminal does, and returns all that the terminal was
/// sent, with carriage returns and escape sequences.
inline std::string shown_on_a_terminal(const char* name, std::vector<std::string> arguments,
                                       const char* no_color = "") {
  arguments.insert(arguments.begin(), program(name).string());
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  int terminal = -1;
  const pid_t process = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (process == 0) {
    ::setenv("TERM", "xterm", 1);
    ::setenv("NO_COLOR", no_color, 1);
    execv(words[0], words.data());
    _exit(127);
  }
  std::string shown;
  char bytes[4096];
  // A terminal whose other end has gone is an error to read (EIO), not an end.
  for (ssize_t count = 0; (count = read(terminal, bytes, sizeof bytes)) > 0;)
    shown.append(bytes, static_cast<std::size_t>(count));
  close(terminal);
  waitpid(process, nullptr, 0);
  return shown;
}

}  // namespace docent::test
