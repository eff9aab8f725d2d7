#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/none.h"

namespace docent {

/// A family of letters that a museum brings along.
struct Typeface {
  static constexpr std::size_t most_files = 8;  ///< Of both of a museum.

  std::string family;  ///< As its files call it, without a comma; empty: docent's own.
  /// In which languages it leads, ascending: those whose letters it has. In others it is not used.
  std::vector<std::uint32_t> languages;
};

/// A font's file, TrueType or OpenType, as it came.
struct FontFile {
  static constexpr std::size_t largest = std::size_t{4} << 20U;  ///< Bytes.

  std::string name;
  std::vector<std::byte> bytes;
};

/// A museum's own look: what docent's screens wear of its house. Colours are sRGB, 0xRRGGBB; the
/// defaults are docent's.
struct Livery {
  std::uint32_t paper = 0xF5F1E8, ink = 0x1E1C1A;
  std::uint32_t accent = 0xD2452D;  ///< What invites to touch.
  std::uint32_t focus = 0x1D7874;   ///< What the keypad would press.
  Typeface titles, text;            ///< Of titles and headings, and of all else.
  /// Images of the museum, after all others; none: there is none. By night, one that does not show
  /// there stands on paper of the day.
  std::uint32_t logo = none, logo_at_night = none;
  bool logo_shows_at_night = false;  ///< It is told from dark paper, too.
};

}  // namespace docent
