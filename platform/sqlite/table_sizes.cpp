#include "platform/sqlite/table_sizes.h"

namespace docent::sqlite {

std::map<std::string, std::uint64_t> table_sizes(const Database& database) {
  std::map<std::string, std::uint64_t> sizes;
  sqlite3_stmt* raw = nullptr;
  sqlite3_prepare_v2(database.handle.get(),
                     "SELECT coalesce(s.tbl_name, d.name), sum(d.pgsize) FROM dbstat AS d "
                     "LEFT JOIN sqlite_schema AS s ON s.name = d.name GROUP BY 1",
                     -1, &raw, nullptr);
  const Statement statement(raw);
  while (sqlite3_step(raw) == SQLITE_ROW)
    sizes[reinterpret_cast<const char*>(sqlite3_column_text(raw, 0))] =
        static_cast<std::uint64_t>(sqlite3_column_int64(raw, 1));
  return sizes;
}

}  // namespace docent::sqlite
