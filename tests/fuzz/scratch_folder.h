#pragma once

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>

namespace docent::test {

/// A folder in memory for what a loader wants to find in files. It goes when the process ends as it
/// should; what crashed leaves its input there.
///
/// By its path it is called the same in every process, so that the same run takes the same way
/// through whatever handles names.
class ScratchFolder {
 public:
  explicit ScratchFolder(std::string_view name)
      : place_(root() / fmt::format("docent-fuzz-{}-{}", name, getpid())) {
    std::filesystem::create_directories(place_);
    constexpr int high = 900;  // nobody else's
    const int opened = ::open(place_.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
    path_ = fmt::format("/proc/self/fd/{}", ::fcntl(opened, F_DUPFD_CLOEXEC, high));
    ::close(opened);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(place_, ignored);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path write(const std::filesystem::path& name,
                                            std::string_view text) const {
    std::ofstream(path_ / name, std::ios::binary | std::ios::trunc)
        .write(text.data(), static_cast<std::streamsize>(text.size()));
    return path_ / name;
  }

 private:
  static std::filesystem::path root() {
    const std::filesystem::path in_memory = "/dev/shm";
    return access(in_memory.c_str(), W_OK) == 0 ? in_memory
                                                : std::filesystem::temp_directory_path();
  }
  std::filesystem::path place_, path_;
};

}  // namespace docent::test
