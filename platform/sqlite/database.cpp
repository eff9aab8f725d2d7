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

/// A file that is there to be read, and how many bytes it has.
struct OpenedFile {
  File file;
  std::uint64_t size = 0;
};

Result<OpenedFile> open_file(const std::filesystem::path& name) {
  std::error_code status;
  if (!std::filesystem::exists(name, status))
    return failure(Errc::NotFound, name,
                   "there is no such database; make it with 'docent-content compile'");
  if (std::filesystem::is_directory(name, status))
    return failure(Errc::InvalidInput, name, "is a folder; name a database file");
  // Opening a pipe would wait for somebody who writes.
  if (!std::filesystem::is_regular_file(name, status))
    return failure(Errc::InvalidInput, name, "is a pipe or a device; name a database file");
  File file(std::fopen(name.c_str(), "rb"));
  const auto size = std::filesystem::file_size(name, status);
  if (!file || status)
    return failure(Errc::Environment, name,
                   fmt::format("cannot be opened ({}); check its permissions",
                               status ? status.message() : std::strerror(errno)));
  return OpenedFile{.file = std::move(file), .size = size};
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

/// Is it one that can be shown, by its first bytes and its size?
Result<void> check_header(const std::filesystem::path& name, std::span<const std::byte> header,
                          std::uint64_t size) {
  const std::string_view start(reinterpret_cast<const char*>(header.data()),
                               std::min(header.size(), magic.size()));
  if (start != magic.substr(0, start.size()))
    return failure(Errc::InvalidInput, name,
                   "is not a docent database; name one made by 'docent-content compile'");
  if (header.size() < header_size)
    return failure(Errc::Damaged, name, "is cut short; copy it again or recompile the content");
  if (big_endian(header, 68, 4) != schema::application_id)
    return failure(Errc::InvalidInput, name,
                   "is a database of another program; name one made by 'docent-content compile'");
  if (const std::uint32_t version = big_endian(header, 60, 4); version != schema::version)
    return failure(
        Errc::WrongVersion, name,
        fmt::format("has schema version {}, and this program reads version {}; recompile the "
                    "content",
                    version, schema::version));
  if (const std::uint64_t promised = promised_size(header); size < promised)
    return failure(Errc::Damaged, name,
                   fmt::format("is cut short ({} of {} bytes); copy it again or recompile the "
                               "content",
                               size, promised));
  return {};
}

/// Reads all of a database. Its header is looked at first: something else may have any size.
Result<std::vector<std::byte>> read_database(const std::filesystem::path& name,
                                             std::uint64_t most) {
  const Result<OpenedFile> opened = open_file(name);
  if (!opened) return std::unexpected(opened.error());
  std::FILE* const file = opened->file.get();
  std::vector<std::byte> bytes(std::min<std::uint64_t>(opened->size, header_size));
  const auto read_on = [&](std::size_t from) {
    return std::fread(bytes.data() + from, 1, bytes.size() - from, file) == bytes.size() - from;
  };
  bool is_read = read_on(0);
  if (is_read)
    if (const auto header = check_header(name, bytes, opened->size); !header)
      return std::unexpected(header.error());
  if (opened->size > most)
    return failure(Errc::InvalidInput, name,
                   fmt::format("has {} MB, and the most that a kiosk shows is {}; compile it with "
                               "fewer or smaller pictures, or several museums of it",
                               opened->size >> 20U, most >> 20U));
  const std::size_t begun = bytes.size();
  bytes.resize(opened->size);
  is_read = is_read && read_on(begun);
  if (!is_read)
    return failure(Errc::Environment, name, "cannot be read to its end; check the disk");
  return bytes;
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

Result<Database> open_database(const std::filesystem::path& file, std::uint64_t most) {
  auto bytes = read_database(file, most);
  if (!bytes) return std::unexpected(bytes.error());
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
