#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "content/content_error.h"
#include "platform/file/read_file.h"
#include "platform/file/text_encoding.h"

namespace docent::content {

/// The bytes of a source; a ContentError of that code where it cannot be read.
inline std::string read_source(const std::filesystem::path& file,
                               std::string code = "unreadable-file", std::string hint = {}) {
  Result<std::string> bytes = file::read_file(file);
  if (!bytes)
    throw to_content_error(bytes.error(), file.string(), std::move(code), std::move(hint));
  return std::move(*bytes);
}

/// What was found wrong with a source's encoding.
inline ContentError to_content_error(const file::EncodingFault& fault, const std::string& file,
                                     std::string code = "not-utf8") {
  return {file, fault.line, fault.column, std::move(code), fault.message, fault.hint};
}

/// The text of a source, without a byte order mark; a ContentError too where it is not UTF-8.
inline std::string read_text_source(const std::filesystem::path& file,
                                    std::string code = "unreadable-file") {
  const std::string bytes = read_source(file, std::move(code));
  if (const auto fault = file::encoding_fault(bytes)) throw to_content_error(*fault, file.string());
  return std::string(file::without_byte_order_mark(bytes));
}

/// The bytes of a recording. Its names may be in any encoding that leaves ASCII as it is, because
/// nothing but their bytes matters; a ContentError where ASCII is not as it is.
inline std::string read_recording(const std::filesystem::path& file) {
  std::string bytes = read_source(file);
  if (const auto fault = file::wide_encoding(bytes)) throw to_content_error(*fault, file.string());
  return bytes;
}

}  // namespace docent::content
