#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace docent::write {

/// A text as TOML writes it, in quotation marks.
std::string toml_text(std::string_view text);

/// A change of a file that people write: everything else in it stays as it is, byte for byte.
struct TomlEdit {
  enum class Kind : std::uint8_t {
    Replace,      ///< The text value that begins at the place becomes `with`.
    InsertAfter,  ///< `with`, a whole line, goes below the value that begins there.
  };
  Kind kind = Kind::Replace;
  std::uint32_t line = 0, column = 0;  ///< Of the value, both from 1, columns in characters.
  std::string with;
};

/// The text with all edits made; their places are those of the text as it is given. An edit whose
/// place holds no text value is left out.
std::string edited(std::string_view toml, std::vector<TomlEdit> edits);

/// What stands before the value in its line: `title.en` of `title.en = "..."`. Empty where that is
/// not the whole statement, as within braces.
std::string key_before(std::string_view toml, std::uint32_t line, std::uint32_t column);

}  // namespace docent::write
