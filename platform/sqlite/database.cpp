#include "platform/sqlite/database.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "platform/sqlite/checksum.h"
#include "platform/sqlite/signature_block.h"
#include "runtime/schema/schema.h"

namespace docent::sqlite {

namespace {

using File = std::unique_ptr<std::FILE, CloseWith<std::fclose>>;

std::unexpected<Error> failure(Errc code, const std::filesystem::path& file,
                               std::string_view sentence) {
  return std::unexpected(Error{code, fmt::format("{}: {}", file.string(), sentence)});
}

Result<std::vector<std::byte>> read_file(const std::filesystem::path& name) {
  std::error_code status;
  if (!std::filesystem::exists(name, status))
    return failure(Errc::NotFound, name,
                   "there is no such database; make it with 'docent-content compile'");
  if (std::filesystem::is_directory(name, status))
    return failure(Errc::InvalidInput, name, "is a folder; name a database file");
  // Opening a pipe would wait for somebody who writes.
  if (!std::filesystem::is_regular_file(name, status))
    return failure(Errc::InvalidInput, name, "is a pipe or a device; name a database file");
  const File file(std::fopen(name.c_str(), "rb"));
  const auto size = std::filesystem::file_size(name, status);
  if (!file || status)
    return failure(Errc::Environment, name,
                   fmt::format("cannot be opened ({}); check its permissions",
                               status ? status.message() : std::strerror(errno)));
  std::vector<std::byte> bytes(size);
  if (std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size())
    return failure(Errc::Environment, name, "cannot be read to its end; check the disk");
  return bytes;
}

/// Fields of SQLite's header are big-endian (https://www.sqlite.org/fileformat2.html, section 1.3).
std::uint32_t big_endian(std::span<const std::byte> bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (const std::byte byte : bytes.subspan(at, size))
    value = value << 8 | std::to_integer<std::uint32_t>(byte);
  return value;
}

constexpr std::size_t header_size = 100;
constexpr std::string_view magic{"SQLite format 3\0", 16};

/// Bytes that the header promises: page size times pages.
std::uint64_t promised_size(std::span<const std::byte> header) {
  const std::uint32_t page_size = big_endian(header, 16, 2);
  const std::uint32_t pages = big_endian(header, 28, 4);
  return std::uint64_t{page_size == 1 ? 65536 : page_size} * pages;
}

Result<void> check_header(const std::filesystem::path& name, std::span<const std::byte> bytes) {
  const std::string_view start(reinterpret_cast<const char*>(bytes.data()),
                               std::min(bytes.size(), magic.size()));
  if (start != magic.substr(0, start.size()))
    return failure(Errc::InvalidInput, name,
                   "is not a docent database; name one made by 'docent-content compile'");
  if (bytes.size() < header_size)
    return failure(Errc::Damaged, name, "is cut short; copy it again or recompile the content");
  if (big_endian(bytes, 68, 4) != schema::application_id)
    return failure(Errc::InvalidInput, name,
                   "is a database of another program; name one made by 'docent-content compile'");
  if (const std::uint32_t version = big_endian(bytes, 60, 4); version != schema::version)
    return failure(
        Errc::WrongVersion, name,
        fmt::format("has schema version {}, and this program reads version {}; recompile the "
                    "content",
                    version, schema::version));
  if (const std::uint64_t promised = promised_size(bytes); bytes.size() < promised)
    return failure(Errc::Damaged, name,
                   fmt::format("is cut short ({} of {} bytes); copy it again or recompile the "
                               "content",
                               bytes.size(), promised));
  return {};
}

/// Opens the bytes, read-only, where they lie.
DatabaseHandle open_bytes(std::vector<std::byte>& bytes) {
  sqlite3* raw = nullptr;
  const int opened =
      sqlite3_open_v2(":memory:", &raw, SQLITE_OPEN_READWRITE | SQLITE_OPEN_MEMORY, nullptr);
  DatabaseHandle handle(raw);  // before the check: SQLite wants even a failed open to be closed
  if (opened != SQLITE_OK) return {};
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  if (sqlite3_deserialize(raw, "main", reinterpret_cast<unsigned char*>(bytes.data()), size, size,
                          SQLITE_DESERIALIZE_READONLY) != SQLITE_OK)
    return {};
  return handle;
}

bool read_checksum(sqlite3* database, Checksum& sum) {
  sqlite3_stmt* raw = nullptr;
  sqlite3_prepare_v2(database, "SELECT blake2b FROM checksum WHERE id = 0", -1, &raw, nullptr);
  const Statement statement(raw);
  if (!statement || sqlite3_step(raw) != SQLITE_ROW) return false;
  const void* blob = sqlite3_column_blob(raw, 0);
  if (blob == nullptr || static_cast<std::size_t>(sqlite3_column_bytes(raw, 0)) != sum.size())
    return false;
  std::memcpy(sum.data(), blob, sum.size());
  return true;
}

bool checksum_matches(const Database& database) {
  const auto place = place_of(database.bytes, database.checksum);
  return place && checksum_of(database.bytes, *place) == database.checksum;
}

/// Takes the signatures off the end of the file, which the header has been checked of.
bool take_signatures(Database& database) {
  const auto pages = static_cast<std::size_t>(promised_size(database.bytes));
  auto signatures = decode_signatures(std::span(database.bytes).subspan(pages));
  if (!signatures) return false;
  database.signatures = std::move(*signatures);
  database.bytes.resize(pages);
  return true;
}

}  // namespace

std::string checksum_text(const Database& database) {
  Checksum sum{};
  std::string text;
  if (read_checksum(database.handle.get(), sum))
    for (const std::byte byte : sum) text += fmt::format("{:02x}", std::to_integer<int>(byte));
  return text;
}

Result<Database> open_database(const std::filesystem::path& file) {
  auto bytes = read_file(file);
  if (!bytes) return std::unexpected(bytes.error());
  if (const auto header = check_header(file, *bytes); !header)
    return std::unexpected(header.error());
  Database database{.bytes = std::move(*bytes), .handle = nullptr};
  if (take_signatures(database)) database.handle = open_bytes(database.bytes);
  if (!database.handle || !read_checksum(database.handle.get(), database.checksum) ||
      !checksum_matches(database))
    return failure(Errc::Damaged, file,
                   "is damaged (its checksum does not match); copy it again or recompile the "
                   "content");
  return database;
}

std::uint32_t schema_version_of(const std::filesystem::path& name) {
  std::error_code status;
  if (!std::filesystem::is_regular_file(name, status)) return 0;
  const File file(std::fopen(name.c_str(), "rb"));
  std::array<std::byte, header_size> header{};
  if (!file || std::fread(header.data(), 1, header.size(), file.get()) != header.size()) return 0;
  return big_endian(header, 68, 4) == schema::application_id ? big_endian(header, 60, 4) : 0;
}

}  // namespace docent::sqlite
