#include "platform/pango/own_fonts.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace docent::pango {
namespace {

/// The bytes as a file without a name. Cairo knows fonts by the names of their files, which are
/// numbers here, so one that has been closed is not soon used again.
FileDescriptor in_memory(std::span<const std::byte> bytes) {
  constexpr int first = 300, many = 400;
  static int next = 0;
  FileDescriptor low(::memfd_create("font", MFD_CLOEXEC));
  FileDescriptor file(::fcntl(low.get(), F_DUPFD_CLOEXEC, first + next));
  next = (next + 1) % many;
  if (file.get() < 0) file = std::move(low);
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
    if (written <= 0) return FileDescriptor();
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return file;
}

std::vector<std::size_t> hashes_of(std::span<const FontFile> files) {
  std::vector<std::size_t> hashes;
  for (const FontFile& file : files)
    hashes.push_back(std::hash<std::string_view>{}(
        {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()}));
  return hashes;
}

}  // namespace

bool OwnFonts::take(std::span<const FontFile> files) {
  std::vector<std::size_t> asked = hashes_of(files);
  if (asked == taken_) return false;
  taken_ = std::move(asked);
  before_ = std::exchange(memory_, {});
  for (const FontFile& file : files) memory_.push_back(in_memory(file.bytes));
  const bool is_any = !memory_.empty() || !before_.empty();
  config_.reset(is_any ? FcInitLoadConfigAndFonts() : nullptr);
  for (const std::vector<FileDescriptor>* set : {&memory_, &before_})
    for (const FileDescriptor& file : *set) {
      const std::string name = fmt::format("/proc/self/fd/{}", file.get());
      if (config_ && file.get() >= 0)
        FcConfigAppFontAddFile(config_.get(), reinterpret_cast<const FcChar8*>(name.c_str()));
    }
  return true;
}

}  // namespace docent::pango
