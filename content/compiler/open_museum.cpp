#include "content/compiler/open_museum.h"

#include "content/content_error.h"
#include "platform/sqlite/content_reader.h"

namespace docent {

namespace {

/// The reader's sentence begins with the file, as does a report of a ContentError.
ContentError to_content_error(const Error& error, const std::filesystem::path& file) {
  const std::string prefix = file.string() + ": ";
  const bool is_prefixed = error.what.starts_with(prefix);
  return {error.code, file.string(), "unusable-database",
          is_prefixed ? error.what.substr(prefix.size()) : error.what};
}

}  // namespace

Database open_or_throw(const std::filesystem::path& file) {
  Result<Database> database = open_database(file);
  if (!database) throw to_content_error(database.error(), file);
  return std::move(*database);
}

Museum load_or_throw(const std::filesystem::path& file) {
  Result<Museum> museum = load_museum(file);
  if (!museum) throw to_content_error(museum.error(), file);
  return std::move(*museum);
}

}  // namespace docent
