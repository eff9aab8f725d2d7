#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "platform/sqlite/database.h"

namespace docent::sqlite {

/// The bytes that each table takes in the file, indices included.
std::map<std::string, std::uint64_t> table_sizes(const Database& database);

}  // namespace docent::sqlite
