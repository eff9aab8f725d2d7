#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/interface/text.h"
#include "runtime/model/place_kind.h"

namespace docent::interface {

/// What a pictogram shows. The kinds of places come first, with the numbers that they have there.
enum class Pictogram : std::uint8_t {
  Exhibits = static_cast<std::uint8_t>(PlaceKind::Count),
  Places,
  StepFree,
  NoEscalators,
  Languages,
  Speak,
  LargerLetters,
  Contrast,
  Lower,
  Search,
  FurtherUp,
  FurtherDown,
  LeafLeft,
  LeafRight,
  Time,
  Count,
};
inline constexpr auto pictogram_count = static_cast<std::size_t>(Pictogram::Count);

constexpr Pictogram pictogram_of(PlaceKind kind) noexcept {
  return static_cast<Pictogram>(kind);
}

/// Draws a pictogram as letters are set: how much of each pixel of a square it covers. The square
/// is `side` pixels wide, at least 1.
TextBitmap draw_pictogram(Pictogram what, std::uint32_t side);

}  // namespace docent::interface
