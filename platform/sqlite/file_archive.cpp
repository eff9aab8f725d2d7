#include "platform/sqlite/file_archive.h"

#include <fmt/core.h>

#include <memory>
#include <string>
#include <utility>

#include "platform/sqlite/database.h"

namespace docent::sqlite {
namespace {

Database open_for_reading(const std::filesystem::path& file) {
  sqlite3* raw = nullptr;
  const int status = sqlite3_open_v2(file.c_str(), &raw, SQLITE_OPEN_READONLY, nullptr);
  Database database{.bytes = {}, .handle = DatabaseHandle(raw)};
  if (status != SQLITE_OK) database.handle.reset();
  return database;
}

/// Where the bytes lie.
struct Column {
  const char *table, *name;
};

Column column_of(Archived what) noexcept {
  switch (what) {
    case Archived::Speech:
      return {"speech", "packets"};
    case Archived::Images:
      return {"image", "bytes"};
    case Archived::Objects:
      break;
  }
  return {"object", "detail"};
}

using Blob = std::unique_ptr<sqlite3_blob, CloseWith<sqlite3_blob_close>>;

class FileArchive : public BlobArchive {
 public:
  FileArchive(DatabaseHandle database, Statement statement, Column column)
      : database_(std::move(database)), statement_(std::move(statement)), column_(column) {}

  std::span<const std::byte> read(std::uint32_t number) override {
    let_go();
    sqlite3_bind_int64(statement_.get(), 1, number);
    if (sqlite3_step(statement_.get()) != SQLITE_ROW) return {};
    const void* bytes = sqlite3_column_blob(statement_.get(), 0);
    if (bytes == nullptr) return {};
    return {static_cast<const std::byte*>(bytes),
            static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), 0))};
  }

  /// The handle stays open from part to part, because it remembers where the pages of a long one
  /// lie.
  bool read_part(std::uint32_t number, std::size_t from, std::span<std::byte> out) override {
    if (!part_ || part_of_ != number) {
      let_go();
      sqlite3_blob* raw = nullptr;
      sqlite3_blob_open(database_.get(), "main", column_.table, column_.name, number, 0, &raw);
      part_.reset(raw);
      part_of_ = number;
    }
    if (!part_) return false;
    const auto size = static_cast<std::size_t>(sqlite3_blob_bytes(part_.get()));
    if (from > size || out.size() > size - from) return false;
    return sqlite3_blob_read(part_.get(), out.data(), static_cast<int>(out.size()),
                             static_cast<int>(from)) == SQLITE_OK;
  }

  void let_go() noexcept override {
    sqlite3_reset(statement_.get());
    part_.reset();
  }

 private:
  DatabaseHandle database_;
  Statement statement_;  // after what it reads from
  Column column_;
  Blob part_{};
  std::uint32_t part_of_ = 0;
};

}  // namespace

std::unique_ptr<BlobArchive> open_archive(const std::filesystem::path& file, Archived what,
                                          std::string_view checksum) {
  Database database = open_for_reading(file);
  if (!database.handle || checksum.empty() || checksum_text(database) != checksum) return {};
  // Nothing is read twice, so nothing need be kept: a few pages.
  sqlite3_exec(database.handle.get(), "PRAGMA cache_size = -64", nullptr, nullptr, nullptr);
  const Column column = column_of(what);
  const std::string query =
      fmt::format("SELECT {} FROM {} WHERE id = ?", column.name, column.table);
  sqlite3_stmt* raw = nullptr;
  sqlite3_prepare_v2(database.handle.get(), query.c_str(), -1, &raw, nullptr);
  Statement statement(raw);
  if (!statement) return {};
  return std::make_unique<FileArchive>(std::move(database.handle), std::move(statement), column);
}

}  // namespace docent::sqlite
