#pragma once

#include <cstdint>
#include <filesystem>

namespace docent::file {

/// Which file it is and when it was last written: another stamp after anything was put in its
/// place, replaced or changed. All zeros: there is none.
struct FileStamp {
  std::uint64_t number = 0;  ///< The file system's own.
  std::uint64_t size = 0;
  std::uint64_t seconds = 0, nanoseconds = 0;
  bool operator==(const FileStamp&) const = default;
};
FileStamp stamp_of(const std::filesystem::path& file) noexcept;

}  // namespace docent::file
