#include "content/command/open_museum.h"

#include "content/content_error.h"
#include "platform/sqlite/content_reader.h"

namespace docent::command {

sqlite::Database open_or_throw(const std::filesystem::path& file) {
  Result<sqlite::Database> database = sqlite::open_database(file);
  if (!database)
    throw content::to_content_error(database.error(), file.string(), "unusable-database");
  return std::move(*database);
}

Museum read_or_throw(const sqlite::Database& database, const std::filesystem::path& file) {
  Result<Museum> museum = sqlite::read_museum(database, file);
  if (!museum) throw content::to_content_error(museum.error(), file.string(), "unusable-database");
  return std::move(*museum);
}

Museum load_or_throw(const std::filesystem::path& file) {
  return read_or_throw(open_or_throw(file), file);
}

}  // namespace docent::command
