#include "runtime/update/delta.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <vector>

#include "platform/file/read_file.h"

namespace docent::update {
namespace {

namespace fs = std::filesystem;

/// Runs a program in a folder, as long as it takes up to half an hour, with no file larger than
/// `most` bytes; is it content?
bool run_in(const fs::path& folder, std::uint64_t most, const std::vector<std::string>& command) {
  constexpr std::uint64_t block = 512;  // dash's; those of other shells are larger
  // The shell sets the limit; its words come as parameters, so nothing in them means anything to
  // it.
  std::vector<std::string> words{
      "sh",
      "-c",
      "cd \"$1\" && ulimit -f \"$2\" && shift 2 && exec timeout 1800 \"$@\"",
      "sh",
      folder.string(),
      std::to_string(most / block + 2)};
  words.insert(words.end(), command.begin(), command.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int out : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, out, "/dev/null", O_WRONLY, 0);
  pid_t process = -1;
  const bool started =
      posix_spawn(&process, "/bin/sh", &actions, nullptr, arguments.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  return started && ::waitpid(process, &status, 0) == process && WIFEXITED(status) &&
         WEXITSTATUS(status) == 0;
}

}  // namespace

bool fetch_delta(const DeltaRequest& request, DeltaFiles& files) {
  std::error_code status;
  fs::remove_all(request.folder, status);
  fs::create_directories(request.folder, status);
  if (status) return false;
  const std::string name = request.url.substr(request.url.rfind('/') + 1);
  files = {.file = request.folder / name, .zchunk = request.folder / (name + ".zck")};
  std::vector<std::string> fetch{"zckdl", "--fail-no-ranges", "-q"};
  if (file::is_there(request.older)) {
    fetch.emplace_back("-s");
    fetch.push_back(fs::absolute(request.older).string());
  }
  fetch.push_back(request.url + ".zck");
  return run_in(request.folder, request.most + request.most / 8, fetch) &&
         run_in(request.folder, request.most, {"unzck", files.zchunk.filename().string()}) &&
         file::is_there(files.file);
}

}  // namespace docent::update
