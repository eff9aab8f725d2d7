#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

extern char** environ;

namespace docent::test {

/// A program while it runs, for tests that signal it or wait for what it does. One that a test
/// leaves running is killed.
class StartedProgram {
 public:
  /// A name without a slash is looked for in PATH. What it says goes to the file `said`, if named.
  StartedProgram(const std::filesystem::path& program, std::vector<std::string> arguments,
                 const std::filesystem::path& said = {}) {
    arguments.insert(arguments.begin(), program.string());
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (!said.empty())
      posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, said.c_str(),
                                       O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (posix_spawnp(&process_, words[0], &actions, nullptr, words.data(), environ) != 0)
      process_ = -1;
    posix_spawn_file_actions_destroy(&actions);
  }
  StartedProgram(const StartedProgram&) = delete;
  StartedProgram& operator=(const StartedProgram&) = delete;
  ~StartedProgram() {
    signal(SIGKILL);
    if (is_there()) wait();
  }

  void signal(int number) const {
    if (is_there()) kill(process_, number);  // without a process it would go to everybody
  }

  /// Waits as long as it takes until something is so; false where the program ended before.
  template <typename IsSo>
  bool runs_until(IsSo is_so) const {
    while (!is_so()) {
      if (has_ended()) return is_so();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }

  /// Stops it wherever it is, until SIGCONT; false where it has ended. Of the signals sent
  /// meanwhile it hears when it goes on.
  bool halt() const {
    signal(SIGSTOP);
    siginfo_t state{};
    waitid(P_PID, static_cast<id_t>(process_), &state, WSTOPPED | WEXITED | WNOWAIT);
    return state.si_code == CLD_STOPPED;
  }

  /// What processors have worked for it so far: its own time, however much others have to do.
  std::chrono::duration<double> processor_time() const {
    if (is_reaped_) return of(usage_.ru_utime) + of(usage_.ru_stime);
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(process_, &clock) == 0) clock_gettime(clock, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
  }

  /// Its exit code, or minus the signal that ended it.
  int wait() {
    int status = 0;
    is_reaped_ = wait4(process_, &status, 0, &usage_) == process_;
    if (!is_reaped_) return -1000;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  bool is_there() const { return process_ > 0 && !is_reaped_; }
  bool has_ended() const {
    siginfo_t state{};
    return waitid(P_PID, static_cast<id_t>(process_), &state, WEXITED | WNOHANG | WNOWAIT) != 0 ||
           state.si_pid == process_;
  }
  static std::chrono::duration<double> of(const timeval& time) {
    return std::chrono::seconds(time.tv_sec) + std::chrono::microseconds(time.tv_usec);
  }

  pid_t process_ = -1;
  bool is_reaped_ = false;
  rusage usage_{};  ///< Of its whole life, once it has been waited for.
};

}  // namespace docent::test
