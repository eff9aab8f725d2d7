#include "content/write/zchunk.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <string>

namespace docent::write {

bool write_zchunk(const std::filesystem::path& file) {
  const std::filesystem::path made = file.string() + ".zck";
  std::string program = "zck", to = "-o", part = made.string() + ".part", from = file.string();
  const std::array<char*, 5> words{program.data(), to.data(), part.data(), from.data(), nullptr};
  pid_t process = -1;
  int status = 0;
  std::error_code failed;
  const bool written =
      posix_spawnp(&process, "zck", nullptr, nullptr, words.data(), environ) == 0 &&
      ::waitpid(process, &status, 0) == process && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (written) std::filesystem::rename(part, made, failed);
  if (written && !failed) return true;
  std::filesystem::remove(part, failed);
  return false;
}

}  // namespace docent::write
