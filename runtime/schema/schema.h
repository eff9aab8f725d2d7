#pragma once

#include <cstdint>

/// The numbers by which a docent database is recognised. Its tables are described in schema.sql,
/// next to this file.
namespace docent::schema {

/// "doct", in SQLite's header.
inline constexpr std::uint32_t application_id = 0x646F6374;

/// SQLite's user_version. Raise it with every change of schema.sql or of the elements of a blob:
/// a kiosk refuses a database of another version and asks for a new compilation.
inline constexpr std::uint32_t version = 22;

/// Bytes. A kiosk has a gigabyte of memory (docent.service), so it does not begin to read a larger
/// database.
inline constexpr std::uint64_t largest_shown = std::uint64_t{1} << 30U;

}  // namespace docent::schema
