#include "content/command/open_museum.h"

#include "content/content_error.h"
#include "platform/sqlite/content_reader.h"

namespace docent {

Database open_or_throw(const std::filesystem::path& file) {
  Result<Database> database = open_database(file);
  if (!database) throw to_content_error(database.error(), file.string(), "unusable-database");
  return std::move(*database);
}

Museum load_or_throw(const std::filesystem::path& file) {
  Result<Museum> museum = load_museum(file);
  if (!museum) throw to_content_error(museum.error(), file.string(), "unusable-database");
  return std::move(*museum);
}

}  // namespace docent
