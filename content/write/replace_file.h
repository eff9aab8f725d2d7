#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace docent::write {

/// Puts `bytes` in the place of `file`, whole or not at all: they are written beside it, flushed to
/// the disk and renamed, so that neither a full disk, an interruption nor a power cut leaves half a
/// file or loses the old one. Throws ContentError: NotFound where the folder does not exist,
/// Environment where the disk refuses.
void replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace docent::write
