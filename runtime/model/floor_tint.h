#pragma once

#include <cstdint>

namespace docent {

/// How many tints there are for the floors of galleries; the renderer gives each its colour.
inline constexpr std::uint8_t floor_tints = 6;
/// Of a floor that has none (SceneryVertex::sky).
inline constexpr std::uint8_t no_floor_tint = 255;

}  // namespace docent
