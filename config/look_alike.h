#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Letters that word processors and keyboards of other languages write in place of those of TOML.
/// Internal to config.
namespace docent::config {

/// A letter that is another than it seems.
struct LookAlike {
  std::string name;        ///< "a no-break space (U+00A0)"; of one that is seen "'–' (U+2013)".
  std::string_view meant;  ///< What belongs there: "-"; empty where nothing does.
  bool is_seen = true;     ///< False: people see nothing, or a blank.
};

/// What a character (UTF-8) stands for where TOML is not a text; empty where it is only itself.
std::optional<LookAlike> look_alike(std::string_view character);

/// The first character of a text that nobody sees, or that looks like a blank and is none.
std::optional<LookAlike> unseen_character(std::string_view text);

/// The code point of a character (UTF-8); bytes that are none stand for themselves.
char32_t letter_of(std::string_view character) noexcept;

/// The first character of a text that is not empty.
std::string_view first_character_of(std::string_view text) noexcept;

}  // namespace docent::config
