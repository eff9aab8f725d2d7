#include "platform/file/read_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <new>

namespace docent::file {
namespace {

/// Closes a file descriptor when it goes.
struct OpenedFile {
  explicit OpenedFile(const std::filesystem::path& file) noexcept
      : descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {}
  OpenedFile(const OpenedFile&) = delete;
  OpenedFile& operator=(const OpenedFile&) = delete;
  ~OpenedFile() {
    if (descriptor >= 0) ::close(descriptor);
  }
  const int descriptor;
};

std::unexpected<Error> failure(Errc code, const std::filesystem::path& file,
                               std::string_view sentence) {
  return std::unexpected(Error{code, fmt::format("{}: {}", file.string(), sentence)});
}

std::unexpected<Error> not_opened(const std::filesystem::path& file, int why) {
  if (why == ENOENT || why == ENOTDIR)
    return failure(Errc::NotFound, file, "there is no such file; check its name");
  if (why == EACCES || why == EPERM)
    return failure(Errc::Environment, file,
                   "may not be read by this user; give it read permission: chmod a+r");
  return failure(
      Errc::Environment, file,
      fmt::format("cannot be opened ({}); check that it may be read", std::strerror(why)));
}

/// A regular file says how long it is; pipes and sysfs do not, or wrongly.
std::size_t expected_size(const struct stat& status, std::size_t most) noexcept {
  return S_ISREG(status.st_mode) && status.st_size > 0
             ? std::min(static_cast<std::size_t>(status.st_size), most)
             : 0;
}

Result<std::string> read_to_end(const std::filesystem::path& file, const OpenedFile& in,
                                std::size_t expected, std::size_t most) {
  std::string text;
  text.reserve(expected);
  std::array<char, 65536> part;
  for (;;) {
    const ssize_t count = ::read(in.descriptor, part.data(), part.size());
    if (count == 0) return text;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      return failure(
          Errc::Environment, file,
          fmt::format("cannot be read to its end ({}); check the disk, or that the device is still "
                      "plugged in",
                      std::strerror(errno)));
    if (text.size() + static_cast<std::size_t>(count) > most)
      return failure(Errc::Environment, file,
                     fmt::format("is larger than {} bytes; is this the right file?", most));
    text.append(part.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& file, std::size_t most) {
  const OpenedFile in(file);  // a pipe that nobody writes may wait here, until a signal
  struct stat status{};
  if (in.descriptor < 0 || ::fstat(in.descriptor, &status) != 0) return not_opened(file, errno);
  if (S_ISDIR(status.st_mode)) return failure(Errc::InvalidInput, file, "is a folder; name a file");
  try {
    return read_to_end(file, in, expected_size(status, most), most);
  } catch (const std::bad_alloc&) {
    return failure(Errc::Environment, file, "is too large for this machine's memory");
  }
}

bool is_there(const std::filesystem::path& name) noexcept {
  std::error_code ignored;
  return std::filesystem::exists(name, ignored);
}

bool may_be_read(const std::filesystem::path& name) noexcept {
  return ::access(name.c_str(), is_folder(name) ? R_OK | X_OK : R_OK) == 0;
}

bool is_folder(const std::filesystem::path& name) noexcept {
  std::error_code ignored;
  return std::filesystem::is_directory(name, ignored);
}

}  // namespace docent::file
