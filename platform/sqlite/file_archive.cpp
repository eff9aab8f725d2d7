#include "platform/sqlite/file_archive.h"

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

const char* query_of(Archived what) noexcept {
  switch (what) {
    case Archived::Speech:
      return "SELECT packets FROM speech WHERE id = ?";
    case Archived::Images:
      return "SELECT bytes FROM image WHERE id = ?";
    case Archived::Objects:
      break;
  }
  return "SELECT detail FROM object WHERE id = ?";
}

class FileArchive : public BlobArchive {
 public:
  FileArchive(DatabaseHandle database, Statement statement)
      : database_(std::move(database)), statement_(std::move(statement)) {}

  std::span<const std::byte> read(std::uint32_t number) override {
    sqlite3_reset(statement_.get());
    sqlite3_bind_int64(statement_.get(), 1, number);
    if (sqlite3_step(statement_.get()) != SQLITE_ROW) return {};
    const void* bytes = sqlite3_column_blob(statement_.get(), 0);
    if (bytes == nullptr) return {};
    return {static_cast<const std::byte*>(bytes),
            static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), 0))};
  }

 private:
  DatabaseHandle database_;
  Statement statement_;  // after what it reads from
};

}  // namespace

std::unique_ptr<BlobArchive> open_archive(const std::filesystem::path& file, Archived what,
                                          std::string_view checksum) {
  Database database = open_for_reading(file);
  if (!database.handle || checksum.empty() || checksum_text(database) != checksum) return {};
  // Nothing is read twice, so nothing need be kept: a few pages.
  sqlite3_exec(database.handle.get(), "PRAGMA cache_size = -64", nullptr, nullptr, nullptr);
  sqlite3_stmt* raw = nullptr;
  sqlite3_prepare_v2(database.handle.get(), query_of(what), -1, &raw, nullptr);
  Statement statement(raw);
  if (!statement) return {};
  return std::make_unique<FileArchive>(std::move(database.handle), std::move(statement));
}

}  // namespace docent::sqlite
