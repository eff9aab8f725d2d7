#pragma once

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "platform/handle.h"
#include "platform/signature/signature.h"
#include "platform/sqlite/checksum.h"
#include "runtime/model/result.h"

namespace docent::sqlite {

using DatabaseHandle = std::unique_ptr<sqlite3, CloseWith<sqlite3_close_v2>>;
using Statement = std::unique_ptr<sqlite3_stmt, CloseWith<sqlite3_finalize>>;

/// A docent database in memory: what was checked is what is read, whatever happens to the file
/// meanwhile.
struct Database {
  /// The file without its signatures. `handle` reads from them, so they stay unchanged.
  std::vector<std::byte> bytes;
  DatabaseHandle handle;
  Checksum checksum{};                             ///< Verified.
  std::vector<signature::Signature> signatures{};  ///< Not verified: signature_block.h does that.
};

/// Reads a database file and checks that it is docent's, of our version, whole and undamaged.
///
/// Errors, each a sentence with the file's name and what to do:
///  - NotFound, Environment: there is no such file; it cannot be read;
///  - InvalidInput: it is not a docent database;
///  - WrongVersion: it is of another schema version;
///  - Damaged: it is cut short, or a byte of it has changed.
///
/// Its header is looked at before the rest is read; InvalidInput where it has more than `most`
/// bytes.
Result<Database> open_database(const std::filesystem::path& file,
                               std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// The checksum that a database was compiled with, in hexadecimal; empty where it has none.
std::string checksum_text(const Database& database);

/// The schema version that a file says it has, without a look at anything but its header; 0 where
/// it is no docent database.
std::uint32_t schema_version_of(const std::filesystem::path& file);

}  // namespace docent::sqlite
