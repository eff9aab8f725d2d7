#pragma once

#include <spawn.h>
#include <sys/wait.h>

#include <string>
#include <vector>

#include "tests/support/reference_data.h"

extern char** environ;

namespace docent::test {

/// One of our programs while it runs, for tests that signal it.
class StartedProgram {
 public:
  StartedProgram(const char* name, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program(name).string());
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    posix_spawn(&process_, words[0], nullptr, nullptr, words.data(), environ);
  }

  pid_t process() const { return process_; }

  /// Its exit code, or minus the signal that ended it.
  int wait() const {
    int status = 0;
    if (waitpid(process_, &status, 0) != process_) return -1000;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  pid_t process_ = -1;
};

}  // namespace docent::test
