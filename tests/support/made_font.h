#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace docent::test {

/// A TrueType font of our own, in which every letter is a black box that fills nearly all of its
/// em: what is set in it is known by its ink.
struct FontSketch {
  std::string family = "House";  ///< ASCII.
  std::u32string letters;        ///< Ascending.
  std::uint16_t embedding = 0;   ///< OS/2 fsType.
};

/// Printable ASCII.
std::u32string latin_letters();

/// The bytes of a TTF file.
std::string make_font(const FontSketch& sketch);

}  // namespace docent::test
