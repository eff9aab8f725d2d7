#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "content/write/content_writer.h"
#include "platform/sqlite/checksum.h"
#include "platform/sqlite/content_reader.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/scratch_folder.h"
#include "tests/support/small_museum.h"

using namespace docent;

namespace {

sqlite::Statement prepare(sqlite3* database, const std::string& sql) {
  sqlite3_stmt* raw = nullptr;
  sqlite3_prepare_v2(database, sql.c_str(), -1, &raw, nullptr);
  return sqlite::Statement(raw);
}

std::vector<std::string> words_of(sqlite3* database, const std::string& sql) {
  std::vector<std::string> words;
  const sqlite::Statement statement = prepare(database, sql);
  while (statement && sqlite3_step(statement.get()) == SQLITE_ROW)
    words.emplace_back(reinterpret_cast<const char*>(sqlite3_column_text(statement.get(), 0)));
  return words;
}

struct Table {
  std::string name, keys;  ///< "(a, b)": what its primary key is made of.
  std::vector<std::string> columns;
};

std::string comma_separated(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

/// A museum's database while it is being spoilt, in memory.
class Patient {
 public:
  explicit Patient(std::span<const std::byte> whole) {
    sqlite3* raw = nullptr;
    sqlite3_open_v2(":memory:", &raw, SQLITE_OPEN_READWRITE | SQLITE_OPEN_MEMORY, nullptr);
    handle_.reset(raw);
    auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(whole.size()));
    std::memcpy(copy, whole.data(), whole.size());
    const auto size = static_cast<sqlite3_int64>(whole.size());
    sqlite3_deserialize(raw, "main", copy, size, size,
                        SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE);
    sqlite3_exec(raw, "PRAGMA journal_mode = OFF", nullptr, nullptr, nullptr);
  }

  [[nodiscard]] sqlite3* handle() const { return handle_.get(); }

  [[nodiscard]] std::vector<std::byte> bytes() const {
    sqlite3_int64 size = 0;
    const unsigned char* file = sqlite3_serialize(handle(), "main", &size, SQLITE_SERIALIZE_NOCOPY);
    const auto all = std::as_bytes(std::span(file, static_cast<std::size_t>(size)));
    return {all.begin(), all.end()};
  }

 private:
  sqlite::DatabaseHandle handle_;
};

constexpr std::size_t page_size = 512;

/// The same database in small pages: it is a fraction as large, and so is what a case costs.
std::vector<std::byte> in_small_pages(std::span<const std::byte> whole) {
  const Patient patient(whole);
  const std::string sql = fmt::format("PRAGMA page_size = {}; VACUUM", page_size);
  sqlite3_exec(patient.handle(), sql.c_str(), nullptr, nullptr, nullptr);
  return patient.bytes();
}

/// What every case begins with: a museum with one of everything, whole and good.
struct Healthy {
  Healthy() {
    const Patient patient(bytes);
    std::memcpy(sum.data(), checksum_in(patient.handle()).data(), sum.size());
    for (const std::string& name : words_of(
             patient.handle(), "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name"))
      if (name != "checksum") tables.push_back(described(patient.handle(), name));
  }

  std::vector<std::byte> bytes = in_small_pages(write::encode_museum(test::small_museum()));
  sqlite::Checksum sum{};
  std::vector<Table> tables;

 private:
  static std::string checksum_in(sqlite3* database) {
    const sqlite::Statement row = prepare(database, "SELECT blake2b FROM checksum");
    if (!row || sqlite3_step(row.get()) != SQLITE_ROW) std::abort();
    return {static_cast<const char*>(sqlite3_column_blob(row.get(), 0)),
            static_cast<std::size_t>(sqlite3_column_bytes(row.get(), 0))};
  }
  static Table described(sqlite3* database, const std::string& name) {
    const std::string from = fmt::format("SELECT name FROM pragma_table_info('{}')", name);
    const std::string key = comma_separated(words_of(database, from + " WHERE pk > 0"));
    return {.name = name, .keys = fmt::format("({})", key), .columns = words_of(database, from)};
  }
};

/// Numbers at which programs trip, or any other.
std::int64_t integer(test::Bytes& bytes) {
  constexpr std::array<std::int64_t, 12> awkward{
      -1, 0, 1, 2, 255, 256, 65535, 65536, 2147483647, 4294967295, 4294967296, INT64_MAX};
  const unsigned which = bytes.byte();
  return which < awkward.size() ? awkward[which] : static_cast<std::int64_t>(bytes.word()) - 1000;
}

double real(test::Bytes& bytes) {
  constexpr std::array<double, 8> awkward{-1, 0, 1e-300, 0.5, 1e9, 1e300, -1e300, 1e-3};
  const unsigned which = bytes.byte();
  if (which < awkward.size()) return awkward[which];
  if (which == 255) return HUGE_VAL;
  return bytes.between(-100, 100);
}

std::string some_bytes(test::Bytes& bytes, std::size_t most) {
  std::string text(std::min<std::size_t>(bytes.byte(), most), '\0');
  for (char& c : text) c = static_cast<char>(bytes.byte());
  return text;
}

/// Changes one cell, or rows. SQLite refuses some of it, which changes nothing.
class Surgeon {
 public:
  Surgeon(const Healthy& healthy, sqlite3* database, test::Bytes& bytes)
      : healthy_(healthy), database_(database), bytes_(bytes) {}

  void operate() {
    const Table& table =
        healthy_.tables[bytes_.below(static_cast<unsigned>(healthy_.tables.size()))];
    const std::string& column =
        table.columns[bytes_.below(static_cast<unsigned>(table.columns.size()))];
    const std::string row =
        fmt::format(" WHERE {0} IN (SELECT {1} FROM {2} LIMIT 1 OFFSET {3})", table.keys,
                    table.keys.substr(1, table.keys.size() - 2), table.name, bytes_.below(4));
    switch (bytes_.below(8)) {
      case 0:
        return set(table, column, row, integer(bytes_));
      case 1:
        return set(table, column, row, real(bytes_));
      case 2:
        return set(table, column, row, some_bytes(bytes_, 60), Kind::Text);
      case 3:
        return set(table, column, row, some_bytes(bytes_, 60), Kind::Blob);
      case 4:
        return run(fmt::format("DELETE FROM {}{}", table.name, row));
      case 5:
        return duplicate(table, column, row);
      case 6:
        return resize(table, column, row);
      default:
        return overwrite(table, column, row);
    }
  }

 private:
  enum class Kind : std::uint8_t { Text, Blob };

  void run(const std::string& sql) const {
    const sqlite::Statement statement = prepare(database_, sql);
    if (statement) sqlite3_step(statement.get());
  }
  sqlite::Statement update(const Table& table, const std::string& column,
                           const std::string& row) const {
    return prepare(database_, fmt::format("UPDATE {} SET {} = ?{}", table.name, column, row));
  }
  void set(const Table& table, const std::string& column, const std::string& row,
           std::int64_t value) const {
    const sqlite::Statement statement = update(table, column, row);
    sqlite3_bind_int64(statement.get(), 1, value);
    sqlite3_step(statement.get());
  }
  void set(const Table& table, const std::string& column, const std::string& row,
           double value) const {
    const sqlite::Statement statement = update(table, column, row);
    sqlite3_bind_double(statement.get(), 1, value);
    sqlite3_step(statement.get());
  }
  void set(const Table& table, const std::string& column, const std::string& row,
           const std::string& value, Kind kind) const {
    const sqlite::Statement statement = update(table, column, row);
    const auto size = static_cast<int>(value.size());
    if (kind == Kind::Text)
      sqlite3_bind_text(statement.get(), 1, value.data(), size, SQLITE_TRANSIENT);
    else
      sqlite3_bind_blob(statement.get(), 1, value.data(), size, SQLITE_TRANSIENT);
    sqlite3_step(statement.get());
  }
  void duplicate(const Table& table, const std::string& column, const std::string& row) const {
    std::vector<std::string> taken = table.columns;
    for (std::string& name : taken)
      if (name == column) name += " + 1";
    run(fmt::format("INSERT INTO {} SELECT {} FROM {}{}", table.name, comma_separated(taken),
                    table.name, row));
  }

  std::string value_of(const Table& table, const std::string& column,
                       const std::string& row) const {
    const sqlite::Statement statement =
        prepare(database_, fmt::format("SELECT {} FROM {}{}", column, table.name, row));
    if (!statement || sqlite3_step(statement.get()) != SQLITE_ROW) return {};
    const void* blob = sqlite3_column_blob(statement.get(), 0);
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement.get(), 0));
    return blob == nullptr ? std::string() : std::string(static_cast<const char*>(blob), size);
  }
  void resize(const Table& table, const std::string& column, const std::string& row) const {
    std::string value = value_of(table, column, row);
    const unsigned by = bytes_.byte();
    if (by < 128)
      value.resize(value.size() - std::min<std::size_t>(by, value.size()));
    else
      value += value.substr(0, by - 127);
    set(table, column, row, value, Kind::Blob);
  }
  /// Up to eight bytes, such as an index, a float or a double.
  void overwrite(const Table& table, const std::string& column, const std::string& row) const {
    std::string value = value_of(table, column, row);
    const std::size_t at = bytes_.word();
    const std::string by = some_bytes(bytes_, 8);
    for (std::size_t i = 0; i < by.size() && !value.empty(); ++i)
      value[(at + i) % value.size()] = by[i];
    set(table, column, row, value, Kind::Blob);
  }

  const Healthy& healthy_;
  sqlite3* database_;
  test::Bytes& bytes_;
};

/// What a bad disk or a bad tool does to the file itself: a byte, or a page in another's place.
void spoil(std::vector<std::byte>& file, test::Bytes& bytes) {
  if (bytes.below(4) > 0) {
    const std::size_t at = (std::size_t{bytes.word()} * page_size + bytes.word()) % file.size();
    file[at] = static_cast<std::byte>(bytes.byte());
    return;
  }
  const std::size_t pages = file.size() / page_size;
  const std::size_t from = bytes.byte() % pages, to = bytes.byte() % pages;
  std::copy_n(file.begin() + static_cast<std::ptrdiff_t>(from * page_size), page_size,
              file.begin() + static_cast<std::ptrdiff_t>(to * page_size));
}

void repair_checksum(std::vector<std::byte>& file, const sqlite::Checksum& stored) {
  const auto place = sqlite::place_of(file, stored);
  if (!place) return;  // It was spoilt itself, and the loader says so.
  const sqlite::Checksum sum = sqlite::checksum_of(file, *place);
  std::ranges::copy(sum, file.begin() + static_cast<std::ptrdiff_t>(*place));
}

Result<Museum> load(std::span<const std::byte> file) {
  static const test::ScratchFolder folder("database");
  return sqlite::load_museum(
      folder.write("museum.db", {reinterpret_cast<const char*>(file.data()), file.size()}));
}

}  // namespace

/// A museum's database, changed as the input says, cell by cell (an even byte, then where and what)
/// and byte by byte (an odd one), with a checksum that is right again. The kiosk's loader refuses
/// it with a sentence, or gives a museum that can be written and read again as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Healthy healthy;
  constexpr int most_changes = 12;
  test::Bytes bytes({data, size});
  const Patient patient(healthy.bytes);
  std::vector<test::Bytes> to_spoil;
  std::vector<std::byte> file;
  for (int change = 0; change < most_changes && !bytes.at_end(); ++change) {
    if (bytes.byte() % 2 == 0) {
      Surgeon(healthy, patient.handle(), bytes).operate();
    } else {
      to_spoil.push_back(bytes);
      for (int skipped = 0; skipped < 6; ++skipped) bytes.byte();
    }
  }
  file = patient.bytes();
  for (test::Bytes& where : to_spoil) spoil(file, where);
  repair_checksum(file, healthy.sum);

  const Result<Museum> museum = load(file);
  if (size == 0 && !museum) __builtin_trap();  // What nobody changed is good.
  if (!museum) {
    if (museum.error().what.empty() || exit_code(museum.error().code) != 1) __builtin_trap();
    return 0;
  }
  const std::vector<std::byte> written = write::encode_museum(*museum);
  const Result<Museum> again = load(written);
  if (!again || write::encode_museum(*again) != written) __builtin_trap();
  return 0;
}
