#include "platform/sqlite/content_reader.h"

#include <fmt/core.h>

#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "runtime/model/moving_picture.h"
#include "runtime/schema/invariants.h"
#include "runtime/schema/rows.h"

namespace docent::sqlite {

namespace {

/// Collects the names of a row's columns: "name, height, vertex".
struct ColumnNames {
  std::string list;

  void operator()(std::string_view name, const auto& /*field*/) {
    if (!list.empty()) list += ", ";
    list += name;
  }
};

/// Takes a statement's columns, from left to right, into fields. Every value is checked for its
/// type and range, so that a foreign row cannot become a wrong value.
struct ColumnReader {
  sqlite3_stmt* statement;
  int next = 0;
  bool sound = true;

  template <typename T>
  void operator()(std::string_view /*name*/, T& field) {
    sound = read(next++, field) && sound;
  }

 private:
  template <typename T>
    requires std::is_integral_v<T>
  [[nodiscard]] bool read(int column, T& field) const {
    const sqlite3_int64 value = sqlite3_column_int64(statement, column);
    if (sqlite3_column_type(statement, column) != SQLITE_INTEGER) return false;
    if (!std::in_range<std::conditional_t<std::is_same_v<T, bool>, unsigned char, T>>(value))
      return false;
    field = static_cast<T>(value);
    return true;
  }
  template <typename T>
    requires std::is_enum_v<T>
  [[nodiscard]] bool read(int column, T& field) const {
    std::underlying_type_t<T> value{};
    const bool read_well = read(column, value);
    field = static_cast<T>(value);
    return read_well;
  }
  template <typename T>
    requires std::is_floating_point_v<T>
  [[nodiscard]] bool read(int column, T& field) const {
    field = static_cast<T>(sqlite3_column_double(statement, column));
    return sqlite3_column_type(statement, column) == SQLITE_FLOAT;
  }
  [[nodiscard]] bool read(int column, std::string& field) const {
    if (sqlite3_column_type(statement, column) != SQLITE_TEXT) return false;
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
    field.assign(text, static_cast<std::size_t>(sqlite3_column_bytes(statement, column)));
    return true;
  }
  template <typename T>
    requires requires(T& array) { schema::decode(std::span<const std::byte>(), array); }
  [[nodiscard]] bool read(int column, T& field) const {
    if (sqlite3_column_type(statement, column) != SQLITE_BLOB) return false;
    const auto* blob = static_cast<const std::byte*>(sqlite3_column_blob(statement, column));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, column));
    return schema::decode(std::span(blob, size), field);
  }
};

/// The store of schema::tables that reads.
class Reader {
 public:
  explicit Reader(sqlite3* database, Videos videos = Videos::Read)
      : database_(database), videos_(videos) {}

  /// Did every row that was asked for exist and hold what it should?
  [[nodiscard]] bool sound() const { return sound_; }
  [[nodiscard]] const std::string& first_fault() const { return fault_; }

  template <typename T>
  void row(std::string_view table, std::size_t id, T& value) {
    std::size_t found = 0;
    read<T>(table, "id", id, [&]() -> T& { return ++found, value; });
    if (found != 1) fail(table);
  }
  template <typename T>
  void rows(std::string_view table, std::vector<T>& values) {
    read<T>(table, {}, 0, [&]() -> T& {
      leave_video(values);
      return values.emplace_back();
    });
    leave_video(values);
  }
  template <typename T>
  void rows_of(std::string_view table, std::string_view parent, std::size_t parent_id,
               std::vector<T>& values) {
    read<T>(table, parent, parent_id, [&]() -> T& { return values.emplace_back(); });
  }
  template <typename Map>
  void texts(std::string_view subject, std::size_t owner, Map& map) {
    const Statement statement = prepare(
        fmt::format("SELECT key, text FROM text WHERE subject = '{}' AND owner = {} ORDER BY key",
                    subject, owner));
    if (!statement) return fail("text");
    int status = SQLITE_ROW;
    while ((status = sqlite3_step(statement.get())) == SQLITE_ROW) {
      ColumnReader reader{statement.get()};
      std::string key;
      reader("key", key);
      reader("text", map[key]);
      if (!reader.sound) return fail("text");
    }
    if (status != SQLITE_DONE) fail("text");
  }

 private:
  /// Of the last one read, so that no two are in memory.
  void leave_video(std::vector<EncodedImage>& images) const {
    if (videos_ == Videos::LeaveInFile && !images.empty() && is_video(images.back()))
      images.back().bytes = {};
  }
  template <typename T>
  void leave_video(std::vector<T>& /*others*/) const {}

  Statement prepare(const std::string& sql) const {
    sqlite3_stmt* raw = nullptr;
    sqlite3_prepare_v2(database_, sql.c_str(), -1, &raw, nullptr);
    return Statement(raw);
  }

  /// Reads the rows whose `key` has the value (all, where there is no key) into what `next_value`
  /// gives.
  template <typename T>
  void read(std::string_view table, std::string_view key, std::size_t key_value,
            auto&& next_value) {
    ColumnNames names;
    schema::columns(names, static_cast<const T&>(T{}));
    const std::string condition =
        key.empty() ? std::string() : fmt::format(" WHERE {} = {}", key, key_value);
    const Statement statement =
        prepare(fmt::format("SELECT {} FROM {}{} ORDER BY id", names.list, table, condition));
    if (!statement) return fail(table);
    int status = SQLITE_ROW;
    while ((status = sqlite3_step(statement.get())) == SQLITE_ROW) {
      ColumnReader reader{statement.get()};
      schema::columns(reader, next_value());
      if (!reader.sound) return fail(table);
    }
    if (status != SQLITE_DONE) fail(table);
  }

  void fail(std::string_view table) {
    if (sound_) fault_ = fmt::format("table {} does not hold what it should", table);
    sound_ = false;
  }

  sqlite3* database_;
  Videos videos_;
  bool sound_ = true;
  std::string fault_;
};

std::unexpected<Error> damaged(const std::filesystem::path& file, const std::string& fault) {
  return std::unexpected(
      Error{Errc::Damaged,
            fmt::format("{}: is damaged ({}); recompile the content", file.string(), fault)});
}

}  // namespace

Result<Museum> read_museum(const Database& database, const std::filesystem::path& file,
                           Videos videos) {
  Museum museum;
  Reader reader(database.handle.get(), videos);
  schema::tables(reader, museum);
  const std::string fault =
      reader.sound() ? schema::broken_invariant(museum) : reader.first_fault();
  if (!fault.empty()) return damaged(file, fault);
  return museum;
}

Result<std::vector<SpeechSound>> read_speech(const Database& database,
                                             const std::filesystem::path& file) {
  std::vector<SpeechSound> speech;
  Reader reader(database.handle.get());
  reader.rows("speech", speech);
  if (!reader.sound()) return damaged(file, reader.first_fault());
  return speech;
}

Result<Museum> load_museum(const std::filesystem::path& file) {
  const auto database = open_database(file);
  if (!database) return std::unexpected(database.error());
  return read_museum(*database, file);
}

}  // namespace docent::sqlite
