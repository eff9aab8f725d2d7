#include "content/write/replace_file.h"

#include <fmt/core.h>

#include "content/content_error.h"
#include "platform/file/read_file.h"
#include "platform/file/write_file.h"

namespace docent::write {

void replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!file::is_folder(folder))
    throw content::ContentError(Errc::NotFound, file.string(), "missing-folder",
                                fmt::format("the folder '{}' does not exist", folder.string()),
                                "create it, or name another output with -o");
  if (const Result<void> written = file::replace_file(file, bytes); !written)
    throw content::to_content_error(written.error(), file.string(), "cannot-write",
                                    "what was there before is unchanged");
}

}  // namespace docent::write
