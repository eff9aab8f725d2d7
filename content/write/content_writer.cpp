#include "content/write/content_writer.h"

#include <fmt/core.h>
#include <sqlite3.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "content/content_error.h"
#include "content/write/replace_file.h"
#include "platform/sqlite/checksum.h"
#include "platform/sqlite/database.h"
#include "runtime/schema/invariants.h"
#include "runtime/schema/rows.h"
#include "runtime/schema/schema.h"
#include "schema_sql.h"

namespace docent::write {

namespace {

[[noreturn]] void fail(sqlite3* database) {
  throw content::ContentError(Errc::Environment, "the database", "database-failed",
                              database != nullptr ? sqlite3_errmsg(database) : "out of memory");
}

[[noreturn]] void too_large(std::size_t bytes) {
  throw content::ContentError(
      Errc::InvalidInput, "the database", "floor-too-large",
      fmt::format("a list of {} MB does not fit: SQLite's largest value has 1000 MB; make several "
                  "floors of this one",
                  bytes / 1'000'000));
}

void execute(sqlite3* database, const std::string& sql) {
  if (sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail(database);
}

/// Collects "name, height, vertex" and as many "?, ?, ?".
struct InsertColumns {
  std::string names, places;

  void operator()(std::string_view name, const auto& /*field*/) {
    names += fmt::format(", {}", name);
    places += ", ?";
  }
};

/// Binds fields to a statement's parameters, from left to right.
struct ColumnWriter {
  sqlite3_stmt* statement;
  int next;

  template <typename T>
  void operator()(std::string_view /*name*/, const T& field) {
    const int place = next++;
    if constexpr (std::is_enum_v<T>)
      sqlite3_bind_int64(statement, place, static_cast<std::underlying_type_t<T>>(field));
    else if constexpr (std::is_integral_v<T>)
      sqlite3_bind_int64(statement, place, static_cast<sqlite3_int64>(field));
    else if constexpr (std::is_floating_point_v<T>)
      sqlite3_bind_double(statement, place, static_cast<double>(field));
    else if constexpr (std::is_convertible_v<T, std::string_view>)
      bind_text(place, field);
    else
      bind_blob(place, schema::encode(field));
  }

 private:
  void bind_text(int place, std::string_view text) {
    sqlite3_bind_text64(statement, place, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
  }
  void bind_blob(int place, std::span<const std::byte> bytes) {
    // A null pointer would bind NULL, and an empty array is not nothing.
    const void* data = bytes.empty() ? static_cast<const void*>("") : bytes.data();
    const int bound = sqlite3_bind_blob64(statement, place, data, bytes.size(), SQLITE_TRANSIENT);
    if (bound == SQLITE_TOOBIG) too_large(bytes.size());
  }
};

/// The store of schema::tables that writes.
class Writer {
 public:
  explicit Writer(sqlite3* database) : database_(database) {}

  template <typename T>
  void row(std::string_view table, std::size_t id, const T& value) {
    insert(table, "id", std::to_string(id), value);
  }
  template <typename T>
  void rows(std::string_view table, const std::vector<T>& values) {
    for (std::size_t id = 0; id < values.size(); ++id) row(table, id, values[id]);
  }
  template <typename T>
  void rows_of(std::string_view table, std::string_view parent, std::size_t parent_id,
               const std::vector<T>& values) {
    for (std::size_t id = 0; id < values.size(); ++id)
      insert(table, fmt::format("{}, id", parent), fmt::format("{}, {}", parent_id, id),
             values[id]);
  }
  template <typename Map>
  void texts(std::string_view subject, std::size_t owner, const Map& map) {
    for (const auto& [key, text] : map) {
      const sqlite::Statement statement = prepare("INSERT INTO text VALUES (?, ?, ?, ?)");
      ColumnWriter writer{statement.get(), 1};
      writer("subject", subject);
      writer("owner", owner);
      writer("key", key);
      writer("text", text);
      step(statement.get());
    }
  }

 private:
  template <typename T>
  void insert(std::string_view table, std::string_view key_names, std::string_view key_values,
              const T& value) {
    InsertColumns columns;
    schema::columns(columns, value);
    const sqlite::Statement statement =
        prepare(fmt::format("INSERT INTO {} ({}{}) VALUES ({}{})", table, key_names, columns.names,
                            key_values, columns.places));
    ColumnWriter writer{statement.get(), 1};
    schema::columns(writer, value);
    step(statement.get());
  }

  sqlite::Statement prepare(const std::string& sql) {
    sqlite3_stmt* raw = nullptr;
    if (sqlite3_prepare_v2(database_, sql.c_str(), -1, &raw, nullptr) != SQLITE_OK) fail(database_);
    return sqlite::Statement(raw);
  }

  void step(sqlite3_stmt* statement) {
    if (sqlite3_step(statement) != SQLITE_DONE) fail(database_);
  }

  sqlite3* database_;
};

/// Stands where the checksum will be until all other bytes are known.
constexpr std::string_view marker = "the file's checksum belongs here";
static_assert(marker.size() == std::tuple_size_v<sqlite::Checksum>);

void write_marker(sqlite3* database) {
  execute(database, fmt::format("INSERT INTO checksum VALUES (0, CAST('{}' AS BLOB))",
                                "the file''s checksum belongs here"));
}

void replace_marker_by_checksum(std::span<std::byte> file) {
  sqlite::Checksum sum{};
  std::memcpy(sum.data(), marker.data(), sum.size());
  const auto place = sqlite::place_of(file, sum);
  if (!place)
    throw content::ContentError(Errc::Environment, "the database", "database-failed",
                                "the place of the checksum cannot be told from other content");
  sum = sqlite::checksum_of(file, *place);
  std::memcpy(file.data() + *place, sum.data(), sum.size());
}

/// A database as the bytes of its file, which lie in the memory that it was made in: an hour of
/// motion is a quarter of a gigabyte, and is there only once.
struct MadeDatabase {
  sqlite::DatabaseHandle database;
  std::span<std::byte> file;
};

sqlite::DatabaseHandle open_in_memory() {
  sqlite3* raw = nullptr;
  const int opened =
      sqlite3_open_v2("museum", &raw, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "memdb");
  sqlite::DatabaseHandle database(raw);
  if (opened != SQLITE_OK) fail(raw);
  sqlite3_int64 most = std::int64_t{1} << 40;  // Else a gigabyte would be the end.
  sqlite3_file_control(raw, "main", SQLITE_FCNTL_SIZE_LIMIT, &most);
  return database;
}

MadeDatabase make_database(const Museum& museum) {
  MadeDatabase made{.database = open_in_memory(), .file = {}};
  sqlite3* raw = made.database.get();
  execute(raw, fmt::format("PRAGMA page_size = 8192; PRAGMA journal_mode = OFF; "
                           "PRAGMA application_id = {}; PRAGMA user_version = {}; BEGIN;",
                           schema::application_id, schema::version));
  execute(raw, schema::sql);
  write_marker(raw);
  Writer writer(raw);
  schema::tables(writer, museum);
  execute(raw, "COMMIT");
  sqlite3_int64 size = 0;
  unsigned char* bytes = sqlite3_serialize(raw, "main", &size, SQLITE_SERIALIZE_NOCOPY);
  if (bytes == nullptr) fail(raw);
  made.file = {reinterpret_cast<std::byte*>(bytes), static_cast<std::size_t>(size)};
  replace_marker_by_checksum(made.file);
  return made;
}

void demand_what_readers_demand(const Museum& museum) {
  const std::string broken = schema::broken_invariant(museum);
  if (broken.empty()) return;
  throw content::ContentError(
      Errc::InvalidInput, "the database", "unusable-museum",
      fmt::format("no kiosk would take this museum: {} is not as it must be", broken),
      "that is docent-content's fault and none of yours; tell its makers, with the sources");
}

}  // namespace

std::vector<std::byte> encode_museum(const Museum& museum) {
  const MadeDatabase made = make_database(museum);
  return {made.file.begin(), made.file.end()};
}

std::size_t write_museum(const Museum& museum, const std::filesystem::path& file) {
  demand_what_readers_demand(museum);
  const MadeDatabase made = make_database(museum);
  replace_file(file, made.file);
  return made.file.size();
}

}  // namespace docent::write
