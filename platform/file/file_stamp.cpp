#include "platform/file/file_stamp.h"

#include <sys/stat.h>

namespace docent::file {

FileStamp stamp_of(const std::filesystem::path& file) noexcept {
  struct stat status{};
  if (::stat(file.c_str(), &status) != 0) return {};
  return {.number = static_cast<std::uint64_t>(status.st_ino),
          .size = static_cast<std::uint64_t>(status.st_size),
          .seconds = static_cast<std::uint64_t>(status.st_mtim.tv_sec),
          .nanoseconds = static_cast<std::uint64_t>(status.st_mtim.tv_nsec)};
}

}  // namespace docent::file
