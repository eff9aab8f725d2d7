#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace docent::import {

/// What a font's file says of itself (OpenType 1.9; TrueType and Type 1 likewise, and WOFF).
struct Font {
  std::string family;              ///< As the designer calls it; not empty, without a comma.
  std::vector<char32_t> letters;   ///< Ascending: the characters that it has.
  bool forbids_embedding = false;  ///< OS/2 fsType: only its maker can allow it to be passed on.
};

/// Reads a font, and looks at each of its letters, so that a damaged one is known here and not on a
/// kiosk. Any bytes are safe. Throws ContentError without a file's name (`unreadable-font`) where
/// they are no font, damaged, several in one file, or pictures instead of outlines.
Font read_font(std::span<const std::byte> bytes);

}  // namespace docent::import
