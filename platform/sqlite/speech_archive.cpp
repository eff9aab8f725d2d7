#include "platform/sqlite/speech_archive.h"

#include <string>
#include <utility>

#include "platform/sqlite/database.h"

namespace docent::sqlite {
namespace {

DatabaseHandle open_for_reading(const std::filesystem::path& file) {
  sqlite3* raw = nullptr;
  const int status = sqlite3_open_v2(file.c_str(), &raw, SQLITE_OPEN_READONLY, nullptr);
  DatabaseHandle handle(raw);
  if (status != SQLITE_OK) return {};
  return handle;
}

Statement prepare(sqlite3* database, const char* sql) {
  sqlite3_stmt* raw = nullptr;
  sqlite3_prepare_v2(database, sql, -1, &raw, nullptr);
  return Statement(raw);
}

/// Does the table hold just these, in this order?
bool holds(sqlite3* database, std::span<const SpeechSound> speech) {
  const Statement statement = prepare(database, "SELECT id, made_of FROM speech ORDER BY id");
  if (!statement) return false;
  for (std::size_t i = 0; i < speech.size(); ++i) {
    if (sqlite3_step(statement.get()) != SQLITE_ROW ||
        sqlite3_column_int64(statement.get(), 0) != static_cast<std::int64_t>(i))
      return false;
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement.get(), 1));
    if (text == nullptr || speech[i].made_of != text) return false;
  }
  return sqlite3_step(statement.get()) == SQLITE_DONE;
}

class SpeechArchive : public sound::SoundArchive {
 public:
  SpeechArchive(DatabaseHandle database, Statement statement)
      : database_(std::move(database)), statement_(std::move(statement)) {}

  std::span<const std::byte> packets(std::uint32_t sound) override {
    sqlite3_reset(statement_.get());
    sqlite3_bind_int64(statement_.get(), 1, sound);
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

std::unique_ptr<sound::SoundArchive> open_speech_archive(const std::filesystem::path& file,
                                                         std::span<const SpeechSound> speech) {
  DatabaseHandle database = open_for_reading(file);
  if (!database || !holds(database.get(), speech)) return {};
  // Nothing is read twice, so nothing need be kept: a few pages.
  sqlite3_exec(database.get(), "PRAGMA cache_size = -64", nullptr, nullptr, nullptr);
  Statement statement = prepare(database.get(), "SELECT packets FROM speech WHERE id = ?");
  if (!statement) return {};
  return std::make_unique<SpeechArchive>(std::move(database), std::move(statement));
}

}  // namespace docent::sqlite
