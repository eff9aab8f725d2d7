#pragma once

#include <sqlite3.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "platform/handle.h"
#include "runtime/model/result.h"

namespace docent::sqlite {

using DatabaseHandle = std::unique_ptr<sqlite3, CloseWith<sqlite3_close_v2>>;
using Statement = std::unique_ptr<sqlite3_stmt, CloseWith<sqlite3_finalize>>;

/// A docent database in memory: what was checked is what is read, whatever happens to the file
/// meanwhile.
struct Database {
  std::vector<std::byte> bytes;  ///< The file. `handle` reads from them, so they stay unchanged.
  DatabaseHandle handle;
};

/// Reads a database file and checks that it is docent's, of our version, whole and undamaged.
///
/// Errors, each a sentence with the file's name and what to do:
///  - NotFound, Environment: there is no such file; it cannot be read;
///  - InvalidInput: it is not a docent database;
///  - WrongVersion: it is of another schema version;
///  - Damaged: it is cut short, or a byte of it has changed.
Result<Database> open_database(const std::filesystem::path& file);

/// The checksum that a database was compiled with, in hexadecimal; empty where it has none.
std::string checksum_text(const Database& database);

}  // namespace docent::sqlite
