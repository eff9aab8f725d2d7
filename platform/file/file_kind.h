#pragma once

#include <cstdint>
#include <string_view>

namespace docent::file {

/// What a file is, to judge by its first bytes and never by its name.
struct FileKind {
  enum class For : std::uint8_t {
    Nothing,  ///< Unknown, or of no use here.
    Plan,     ///< `docent-content import` makes a museum's files of it.
    Picture,  ///< An exhibit's picture may be one.
  };
  std::string_view name;  ///< "a DXF drawing"; empty where it is unknown.
  For use = For::Nothing;
  std::string_view remedy{};  ///< What to do with one that nothing here reads.
};

/// Looks at the first bytes of a file. Any bytes are answered; those of a plain text have no name.
FileKind file_kind(std::string_view bytes) noexcept;

}  // namespace docent::file
