#pragma once

#include <filesystem>

#include "platform/sqlite/database.h"
#include "runtime/model/museum.h"

namespace docent::command {

/// Opens a database for a command. Throws ContentError with the reader's sentence where it cannot.
sqlite::Database open_or_throw(const std::filesystem::path& file);

/// Reads the museum of a database. Both throw as open_or_throw does.
Museum read_or_throw(const sqlite::Database& database, const std::filesystem::path& file);
Museum load_or_throw(const std::filesystem::path& file);

}  // namespace docent::command
