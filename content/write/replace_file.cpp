#include "content/write/replace_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "content/content_error.h"
#include "platform/file/read_file.h"

namespace docent::write {

namespace {

/// A new file beside the one to be replaced; gone again unless it was kept.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& beside)
      : name_(beside.string() + fmt::format(".{}.part", ::getpid())),
        descriptor_(::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    ::unlink(name_.c_str());  // fails, as it should, once the file was renamed
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

  [[nodiscard]] bool rename_to(const std::filesystem::path& file) const {
    return std::rename(name_.c_str(), file.c_str()) == 0;
  }

 private:
  std::string name_;
  int descriptor_;
};

/// Makes the renaming itself last; a file system that cannot do that has done what it could.
void flush_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw content::ContentError(Errc::Environment, file.string(), "cannot-write",
                              fmt::format("cannot be written: {}", std::strerror(errno)),
                              "what was there before is unchanged");
}

}  // namespace

void replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!file::is_folder(folder))
    throw content::ContentError(Errc::NotFound, file.string(), "missing-folder",
                                fmt::format("the folder '{}' does not exist", folder.string()),
                                "create it, or name another output with -o");
  const TemporaryFile temporary(file);
  if (!temporary.is_open() || !temporary.write(bytes) || !temporary.rename_to(file)) fail(file);
  flush_folder(folder);
}

}  // namespace docent::write
