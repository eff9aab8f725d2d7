#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "runtime/scene/theme.h"

namespace docent::scene {

/// What a coat is made of besides its own colour, so that two guides are told apart in grey too.
enum class CoatPattern : std::uint8_t {
  Plain,
  Hoops,    ///< Broad bands round body and sleeves.
  Stripes,  ///< Upright.
  Yoke,     ///< Shoulders and upper sleeves.
  Skirt,    ///< All below the hips.
  Sash,     ///< A band from the left shoulder to the right hip.
  Diamonds,
  Checks,
};

/// How one avatar is told from another. Colours are sRGB, 0xRRGGBB.
///
/// Height moves no foot: bodies are stretched upright from the floor, so that a planted sole stays
/// where the walk has planted it. The pattern, the girths and the hair are those of the guide's
/// pictogram on a card; the body itself is modelled (content/avatar).
struct Look {
  std::string_view name;               ///< Stable, the same in every language.
  std::uint32_t coat = 0, second = 0;  ///< `second` is the pattern's colour.
  CoatPattern pattern = CoatPattern::Plain;
  std::uint32_t trousers = 0, shoes = 0, shirt = 0, hair = 0, skin = 0;
  std::uint32_t figure = 0;       ///< Whose body: of those in the database, in turn.
  float height = 1;               ///< Share of the skeleton's height; the stride stays.
  float shoulders = 1, hips = 1;  ///< Shares of the mesh's width and depth there.
  float hair_volume = 0;          ///< Metres that the hair stands out further.
  float hair_length = 0;          ///< Metres that it hangs down further behind.
};

/// How many of `looks` are for guides: each in one saturated colour, which its trail has too. They
/// come first; the others, in quiet colours, are for strollers.
inline constexpr std::size_t guide_look_count = 8;

/// The coats of guides lie at least 15 apart (CIE 1976 Lab), also for eyes that lack a kind of
/// cone, and as far from oak and stone (tests/runtime/scene/look_test.cpp).
inline constexpr std::array<Look, 12> looks{{
    {.name = "teal",
     .coat = 0x1D7874,
     .second = 0x1D7874,
     .trousers = 0x35322F,
     .shoes = 0x2A2420,
     .shirt = 0xF0EADD,
     .hair = 0x2E2420,
     .skin = 0xC99A7C,
     .figure = 0},
    {.name = "vermilion",
     .coat = 0xDC4522,
     .second = 0x5E1B14,
     .pattern = CoatPattern::Hoops,
     .trousers = 0x3B4048,
     .shoes = 0x2A2420,
     .shirt = 0xF0EADD,
     .hair = 0xA5622F,
     .skin = 0xE3BFA5,
     .figure = 1,
     .height = 1.05F,
     .shoulders = 0.97F,
     .hips = 0.90F},
    {.name = "saffron",
     .coat = 0xF4A827,
     .second = 0x3A2C28,
     .pattern = CoatPattern::Skirt,
     .trousers = 0x3A2C28,
     .shoes = 0x6B2A20,
     .shirt = 0xF6F0E0,
     .hair = 0x1C1714,
     .skin = 0x8A5E44,
     .figure = 2,
     .height = 0.95F,
     .shoulders = 0.96F,
     .hips = 1.10F,
     .hair_length = 0.13F},
    {.name = "navy",
     .coat = 0x223276,
     .second = 0xE8E2D2,
     .pattern = CoatPattern::Sash,
     .trousers = 0x8A867D,
     .shoes = 0x2A2420,
     .shirt = 0xF0EADD,
     .hair = 0xB9B2A6,
     .skin = 0xDDB497,
     .figure = 3,
     .height = 1.03F,
     .shoulders = 1.13F,
     .hips = 1.04F},
    {.name = "sky",
     .coat = 0x71A8F8,
     .second = 0x2E5FA8,
     .pattern = CoatPattern::Stripes,
     .trousers = 0xE7E0D0,
     .shoes = 0xF0EADD,
     .shirt = 0xF6F0E0,
     .hair = 0x1C1714,
     .skin = 0x6F4630,
     .figure = 4,
     .height = 1.01F,
     .shoulders = 1.03F,
     .hips = 0.92F,
     .hair_volume = 0.035F},
    {.name = "rose",
     .coat = 0xECA0CC,
     .second = 0xA33A68,
     .pattern = CoatPattern::Diamonds,
     .trousers = 0x5B4A55,
     .shoes = 0xA33A68,
     .shirt = 0xF6F0E0,
     .hair = 0xD9B46A,
     .skin = 0xE8C6AE,
     .figure = 5,
     .height = 0.94F,
     .shoulders = 0.94F,
     .hips = 1.04F,
     .hair_volume = 0.008F,
     .hair_length = 0.17F},
    {.name = "ivory",
     .coat = 0xF0ECDE,
     .second = 0x35322F,
     .pattern = CoatPattern::Yoke,
     .trousers = 0xA58F6E,
     .shoes = 0x6A4B34,
     .shirt = 0x35322F,
     .hair = 0x4A2E20,
     .skin = 0xB98467,
     .figure = 6,
     .height = 0.98F,
     .shoulders = 1.16F,
     .hips = 1.18F},
    {.name = "plum",
     .coat = 0x701438,
     .second = 0xC98AA0,
     .pattern = CoatPattern::Checks,
     .trousers = 0x2B2427,
     .shoes = 0x2A2420,
     .shirt = 0xF0EADD,
     .hair = 0x2B211E,
     .skin = 0xD2A584,
     .figure = 7,
     .height = 0.97F,
     .shoulders = 1.02F,
     .hips = 1.14F,
     .hair_volume = 0.018F,
     .hair_length = 0.05F},
    {.name = "stone",
     .coat = 0x8C8578,
     .second = 0x8C8578,
     .trousers = 0x5B554D,
     .shoes = 0x3A322C,
     .shirt = 0xD9D2C4,
     .hair = 0x4A3A2E,
     .skin = 0xB98467,
     .figure = 4,
     .height = 1.02F},
    {.name = "sand",
     .coat = 0xB4A792,
     .second = 0x6A6259,
     .pattern = CoatPattern::Skirt,
     .trousers = 0x6A6259,
     .shoes = 0x463C34,
     .shirt = 0xE6DFD1,
     .hair = 0x6F5A45,
     .skin = 0xDDB497,
     .figure = 5,
     .height = 0.95F,
     .shoulders = 0.96F,
     .hips = 1.06F,
     .hair_length = 0.12F},
    {.name = "slate",
     .coat = 0x6F6F6A,
     .second = 0x6F6F6A,
     .trousers = 0x4B4844,
     .shoes = 0x2E2924,
     .shirt = 0xCFC8BA,
     .hair = 0x231D1A,
     .skin = 0x8A5E44,
     .figure = 0,
     .height = 1.04F,
     .shoulders = 1.08F,
     .hips = 1.02F},
    {.name = "clay",
     .coat = 0xA08E7A,
     .second = 0x777066,
     .pattern = CoatPattern::Yoke,
     .trousers = 0x777066,
     .shoes = 0x4A4139,
     .shirt = 0xDDD5C6,
     .hair = 0x9A948B,
     .skin = 0xE3BFA5,
     .figure = 6,
     .height = 0.98F,
     .shoulders = 1.08F,
     .hips = 1.14F},
}};

/// A guide's trail bears the colour of its coat.
inline Colour trail_colour(std::size_t look) noexcept {
  return srgb(looks[look % looks.size()].coat);
}

}  // namespace docent::scene
