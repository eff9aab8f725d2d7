#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "runtime/model/museum.h"

namespace docent::write {

/// The museum, whatever it is, as the bytes of a database file: the same museum always gives the
/// same bytes. Throws ContentError where SQLite fails, which is out of memory.
std::vector<std::byte> encode_museum(const Museum& museum);

/// Writes the museum to a database, if it is what a reader demands (schema/invariants.h). The file
/// appears whole or not at all: it is written beside its place, flushed to the disk and renamed.
/// Returns its size in bytes. Throws ContentError, and leaves what existed before, where a kiosk
/// would refuse the museum, and of kind Environment or NotFound where it cannot be written.
std::size_t write_museum(const Museum& museum, const std::filesystem::path& file);

}  // namespace docent::write
