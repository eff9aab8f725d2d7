#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "runtime/model/result.h"

namespace docent::file {

/// Bytes. No database and no file that people write is larger: a larger file is the wrong one.
constexpr std::size_t largest_file = std::size_t{4} << 30U;

/// The bytes of a file, a pipe or a node of sysfs, to its end.
///
/// Never throws, whatever the world does meanwhile: a folder, a file that may not be read, one that
/// vanishes or whose device goes between opening and reading, and one of more than `most` bytes
/// each fail with a sentence that names the file and what to do.
Result<std::string> read_file(const std::filesystem::path& file, std::size_t most = largest_file);

/// Is there anything of that name? False too where this user may not look.
bool is_there(const std::filesystem::path& name) noexcept;
bool is_folder(const std::filesystem::path& name) noexcept;
/// May this user read it, and list it where it is a folder?
bool may_be_read(const std::filesystem::path& name) noexcept;

}  // namespace docent::file
