#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "platform/sqlite/database.h"
#include "runtime/model/museum.h"
#include "runtime/model/result.h"

namespace docent::sqlite {

/// What becomes of the bytes of a museum's videos: many megabytes each, which whoever plays them
/// finds in the file (file_archive.h).
enum class Videos : std::uint8_t { Read, LeaveInFile };

/// Reads a museum from its database and checks every index in it once, so that nobody who gets the
/// museum needs to. Fails as open_database does; a database whose rows do not make a museum is
/// Damaged. `file` is only named in the error.
Result<Museum> read_museum(const Database& database, const std::filesystem::path& file,
                           Videos videos = Videos::Read);

/// Only what the museum says, as it was compiled: for whoever makes it anew, and takes over what
/// has not changed. Nothing of it is checked but that each row can be read.
Result<std::vector<SpeechSound>> read_speech(const Database& database,
                                             const std::filesystem::path& file);

/// Opens and reads.
Result<Museum> load_museum(const std::filesystem::path& file);

}  // namespace docent::sqlite
