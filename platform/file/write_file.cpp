#include "platform/file/write_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

namespace docent::file {
namespace {

/// A new file; gone again unless it was kept.
class NewFile {
 public:
  NewFile(std::string name, mode_t mode)
      : name_(std::move(name)),
        descriptor_(::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode)) {
    if (descriptor_ >= 0) ::fchmod(descriptor_, mode);  // whatever the umask takes away
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    if (!is_kept_) ::unlink(name_.c_str());
  }

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }

  [[nodiscard]] bool write(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return ::fsync(descriptor_) == 0;
  }

  [[nodiscard]] bool rename_to(const std::filesystem::path& file) {
    is_kept_ = std::rename(name_.c_str(), file.c_str()) == 0;
    return is_kept_;
  }
  void keep() noexcept { is_kept_ = true; }

 private:
  std::string name_;
  int descriptor_;
  bool is_kept_ = false;
};

std::unexpected<Error> failure(const std::filesystem::path& file, int why) {
  return std::unexpected(Error{Errc::Environment, fmt::format("{}: cannot be written: {}",
                                                              file.string(), std::strerror(why))});
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

}  // namespace

Result<void> replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes,
                          mode_t mode) {
  NewFile beside(file.string() + fmt::format(".{}.part", ::getpid()), mode);
  if (!beside.is_open() || !beside.write(bytes) || !beside.rename_to(file))
    return failure(file, errno);
  flush_folder(folder_of(file));
  return {};
}

Result<void> create_file(const std::filesystem::path& file, std::span<const std::byte> bytes,
                         mode_t mode) {
  NewFile made(file.string(), mode);
  if (!made.is_open() && errno == EEXIST)
    return std::unexpected(
        Error{Errc::Environment,
              file.string() + ": exists already and is left as it is; choose another name"});
  if (!made.is_open() || !made.write(bytes)) return failure(file, errno);
  made.keep();
  flush_folder(folder_of(file));
  return {};
}

void flush_folder(const std::filesystem::path& folder) noexcept {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace docent::file
