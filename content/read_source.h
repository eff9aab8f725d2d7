#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "content/content_error.h"
#include "platform/file/read_file.h"

namespace docent::content {

/// The bytes of a source; a ContentError of that code where it cannot be read.
inline std::string read_source(const std::filesystem::path& file,
                               std::string code = "unreadable-file", std::string hint = {}) {
  Result<std::string> bytes = file::read_file(file);
  if (!bytes)
    throw to_content_error(bytes.error(), file.string(), std::move(code), std::move(hint));
  return std::move(*bytes);
}

}  // namespace docent::content
