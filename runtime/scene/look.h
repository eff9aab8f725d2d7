#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "runtime/scene/theme.h"

namespace docent::scene {

/// What a head shows from afar: hair, or what is worn. No two guides have the same, so that they
/// are told apart without any colour.
enum class Crown : std::uint8_t { Short, Bun, Curls, Long, Bald, Turban, Cap, Scarf };

/// A body (content/avatar) as a pictogram tells it, in shares of its height.
struct Outline {
  Crown crown = Crown::Short;
  bool beard = false, bare_legs = false;
  float hem = 0.34F;    ///< Where the garment ends above the floor...
  float flare = 1;      ///< ... and how wide it is there, beside the shoulders.
  float shoulders = 1;  ///< Beside those of an ordinary guide.
};

/// How one avatar is told from another. Colours are sRGB, 0xRRGGBB.
///
/// Height moves no foot: bodies are stretched upright from the floor, so that a planted sole stays
/// where the walk has planted it.
struct Look {
  std::string_view name;               ///< Stable, the same in every language.
  std::uint32_t coat = 0, second = 0;  ///< `second` is a turban's or scarf's colour.
  std::uint32_t trousers = 0, shoes = 0, shirt = 0, hair = 0, skin = 0;
  std::uint32_t figure = 0;  ///< Whose body: of those in the database, in turn.
  float height = 1;          ///< Share of the skeleton's height; the stride stays.
  Outline outline{};
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
     .trousers = 0x3B4048,
     .shoes = 0x2A2420,
     .shirt = 0xF0EADD,
     .hair = 0xA5622F,
     .skin = 0xE3BFA5,
     .figure = 1,
     .height = 1.05F,
     .outline =
         {.crown = Crown::Bun, .bare_legs = true, .hem = 0.27F, .flare = 1.2F, .shoulders = 0.93F}},
    {.name = "saffron",
     .coat = 0xF4A827,
     .second = 0x3A2C28,
     .trousers = 0x3A2C28,
     .shoes = 0x6B2A20,
     .shirt = 0xF6F0E0,
     .hair = 0x1C1714,
     .skin = 0x8A5E44,
     .figure = 2,
     .height = 0.95F,
     .outline = {.crown = Crown::Turban, .beard = true, .hem = 0.33F}},
    {.name = "navy",
     .coat = 0x223276,
     .second = 0xE8E2D2,
     .trousers = 0x8A867D,
     .shoes = 0x2A2420,
     .shirt = 0xF0EADD,
     .hair = 0xB9B2A6,
     .skin = 0xDDB497,
     .figure = 3,
     .height = 1.03F,
     .outline = {.crown = Crown::Cap, .hem = 0.45F, .shoulders = 1.1F}},
    {.name = "sky",
     .coat = 0x71A8F8,
     .second = 0x2E5FA8,
     .trousers = 0xE7E0D0,
     .shoes = 0xF0EADD,
     .shirt = 0xF6F0E0,
     .hair = 0x1C1714,
     .skin = 0x6F4630,
     .figure = 4,
     .height = 1.01F,
     .outline = {.crown = Crown::Curls, .hem = 0.44F}},
    {.name = "rose",
     .coat = 0xECA0CC,
     .second = 0xA33A68,
     .trousers = 0x5B4A55,
     .shoes = 0xA33A68,
     .shirt = 0xF6F0E0,
     .hair = 0xD9B46A,
     .skin = 0xE8C6AE,
     .figure = 5,
     .height = 0.94F,
     .outline = {.crown = Crown::Long, .hem = 0.40F, .flare = 1.15F, .shoulders = 0.92F}},
    {.name = "ivory",
     .coat = 0xF0ECDE,
     .second = 0x35322F,
     .trousers = 0xA58F6E,
     .shoes = 0x6A4B34,
     .shirt = 0x35322F,
     .hair = 0x4A2E20,
     .skin = 0xB98467,
     .figure = 6,
     .height = 0.98F,
     .outline =
         {.crown = Crown::Bald, .beard = true, .hem = 0.40F, .flare = 1.1F, .shoulders = 1.12F}},
    {.name = "plum",
     .coat = 0x701438,
     .second = 0xC98AA0,
     .trousers = 0x2B2427,
     .shoes = 0x2A2420,
     .shirt = 0xF0EADD,
     .hair = 0x2B211E,
     .skin = 0xD2A584,
     .figure = 7,
     .height = 0.97F,
     .outline = {.crown = Crown::Scarf, .hem = 0.05F, .flare = 1.25F, .shoulders = 0.95F}},
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
     .trousers = 0x6A6259,
     .shoes = 0x463C34,
     .shirt = 0xE6DFD1,
     .hair = 0x6F5A45,
     .skin = 0xDDB497,
     .figure = 5,
     .height = 0.95F},
    {.name = "slate",
     .coat = 0x6F6F6A,
     .second = 0x6F6F6A,
     .trousers = 0x4B4844,
     .shoes = 0x2E2924,
     .shirt = 0xCFC8BA,
     .hair = 0x231D1A,
     .skin = 0x8A5E44,
     .figure = 0,
     .height = 1.04F},
    {.name = "clay",
     .coat = 0xA08E7A,
     .second = 0x777066,
     .trousers = 0x777066,
     .shoes = 0x4A4139,
     .shirt = 0xDDD5C6,
     .hair = 0x9A948B,
     .skin = 0xE3BFA5,
     .figure = 6,
     .height = 0.98F},
}};

/// Which of a database's bodies somebody with this look wears: guides the museum's own character
/// where it has one, which is the last body; strollers one of ours.
inline std::uint32_t body_of(std::size_t look, std::size_t bodies, bool has_own) noexcept {
  const auto count = static_cast<std::uint32_t>(bodies);
  const std::size_t index = look % looks.size();
  if (count == 0 || (has_own && index < guide_look_count)) return count == 0 ? 0 : count - 1;
  const std::uint32_t ours = has_own && count > 1 ? count - 1 : count;
  return looks[index].figure % ours;
}

/// A guide's trail bears the colour of its coat.
inline Colour trail_colour(std::size_t look) noexcept {
  return srgb(looks[look % looks.size()].coat);
}

}  // namespace docent::scene
