#include "content/speech/run_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/personality.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "content/content_error.h"

namespace docent::speech {

namespace {

using Clock = std::chrono::steady_clock;

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  void close() {
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  }
  [[nodiscard]] int get() const { return descriptor_; }

 private:
  int descriptor_;
};

[[noreturn]] void no_pipe() {
  throw content::ContentError(Errc::Environment, "a program's input and output", "no-pipe",
                              std::strerror(errno));
}

/// The input as a file in memory: no pipe that could fill, and nobody to wait for.
int file_of(std::string_view input) {
  const int file = ::memfd_create("input", MFD_CLOEXEC);
  if (file < 0) no_pipe();
  while (!input.empty()) {
    const ssize_t written = ::write(file, input.data(), input.size());
    if (written <= 0) {
      ::close(file);
      no_pipe();
    }
    input.remove_prefix(static_cast<std::size_t>(written));
  }
  ::lseek(file, 0, SEEK_SET);
  return file;
}

struct Pipe {
  Pipe() : Pipe(make()) {}
  Descriptor read, write;

 private:
  explicit Pipe(std::array<int, 2> ends) : read(ends[0]), write(ends[1]) {}
  static std::array<int, 2> make() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) no_pipe();
    return ends;
  }
};

/// What this thread starts lies at the same addresses each time, where the system allows that.
class SamePlaces {
 public:
  SamePlaces() : before_(::personality(asks)) {
    if (before_ >= 0) ::personality(static_cast<unsigned long>(before_) | ADDR_NO_RANDOMIZE);
  }
  SamePlaces(const SamePlaces&) = delete;
  SamePlaces& operator=(const SamePlaces&) = delete;
  ~SamePlaces() {
    if (before_ >= 0) ::personality(static_cast<unsigned long>(before_));
  }

 private:
  static constexpr unsigned long asks = 0xffffffff;
  int before_;
};

/// As C takes them: with a null pointer after the last.
std::vector<char*> pointers_to(const std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

/// Our own environment, in which a folder of libraries comes first.
std::vector<std::string> environment_with(const std::string& libraries) {
  constexpr std::string_view name = "LD_LIBRARY_PATH=";
  std::vector<std::string> environment;
  std::string path = std::string(name) + libraries;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view value = *entry;
    if (value.starts_with(name))
      path.append(":").append(value.substr(name.size()));
    else
      environment.emplace_back(value);
  }
  environment.push_back(std::move(path));
  return environment;
}

/// Starts it; the error number where it cannot be.
int start(const std::vector<std::string>& words, const std::string& libraries, int input,
          int output, int errors, pid_t& process) {
  const std::vector<char*> arguments = pointers_to(words);
  const std::vector<std::string> environment =
      libraries.empty() ? std::vector<std::string>{} : environment_with(libraries);
  const std::vector<char*> with_libraries = pointers_to(environment);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  const SamePlaces same;
  const int failed = ::posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(),
                                    libraries.empty() ? environ : with_libraries.data());
  posix_spawn_file_actions_destroy(&actions);
  return failed;
}

/// Appends what can be read; false at the end.
bool take(int from, std::string& into, std::size_t most) {
  std::array<char, 8192> part{};  // programs write half of that at a time
  const ssize_t count = ::read(from, part.data(), part.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  if (into.size() < most) into.append(part.data(), static_cast<std::size_t>(count));
  return count > 0;
}

/// Reads both to their ends; false where that takes too long or is too much.
bool listen(Pipe& output, Pipe& errors, Outcome& outcome, Clock::time_point end, std::size_t most) {
  std::array<pollfd, 2> waits{pollfd{output.read.get(), POLLIN, 0},
                              pollfd{errors.read.get(), POLLIN, 0}};
  const std::array<std::string*, 2> texts{&outcome.output, &outcome.errors};
  const std::array<std::size_t, 2> limits{most + 1, 4096};
  while (waits[0].fd >= 0 || waits[1].fd >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0) return outcome.kind = Outcome::Kind::TooSlow, false;
    if (::poll(waits.data(), waits.size(), static_cast<int>(left.count())) < 0) continue;
    for (std::size_t i = 0; i < waits.size(); ++i)
      if (waits[i].revents != 0 && !take(waits[i].fd, *texts[i], limits[i])) waits[i].fd = -1;
    if (outcome.output.size() > most) return outcome.kind = Outcome::Kind::TooMuch, false;
  }
  return true;
}

/// Waits for a process that has closed its outputs; false where it goes on all the same.
bool ends_before(pid_t process, Clock::time_point end) {
  const Descriptor watched(static_cast<int>(::syscall(SYS_pidfd_open, process, 0U)));
  pollfd wait{watched.get(), POLLIN, 0};
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
  return ::poll(&wait, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0))) > 0;
}

}  // namespace

Outcome run_program(const std::vector<std::string>& words, std::string_view input,
                    std::chrono::milliseconds patience, std::size_t most,
                    const std::string& libraries) {
  const Descriptor text(file_of(input));
  Pipe output, errors;
  Outcome outcome;
  pid_t process = -1;
  if (const int failed =
          start(words, libraries, text.get(), output.write.get(), errors.write.get(), process);
      failed != 0) {
    outcome.kind = Outcome::Kind::Missing;
    outcome.errors = std::strerror(failed);
    return outcome;
  }
  output.write.close();
  errors.write.close();
  const Clock::time_point end = Clock::now() + patience;
  if (listen(output, errors, outcome, end, most) && !ends_before(process, end))
    outcome.kind = Outcome::Kind::TooSlow;
  if (outcome.kind != Outcome::Kind::Ended) ::kill(process, SIGKILL);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

}  // namespace docent::speech
