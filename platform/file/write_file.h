#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <span>

#include "runtime/model/result.h"

/// Files that appear whole or not at all, whatever happens: a full disk, an interruption, a power
/// cut. Each failure is a sentence with the file's name.
namespace docent::file {

/// Puts `bytes` in the place of `file`: they are written beside it, flushed to the disk and
/// renamed, and the folder is flushed. What was there before is unchanged where that fails.
Result<void> replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes,
                          mode_t mode = 0644);

/// Makes a new file; fails, and changes nothing, where there is anything of that name.
Result<void> create_file(const std::filesystem::path& file, std::span<const std::byte> bytes,
                         mode_t mode = 0644);

/// Makes renamings in this folder last; a file system that cannot do that has done what it could.
void flush_folder(const std::filesystem::path& folder) noexcept;

}  // namespace docent::file
