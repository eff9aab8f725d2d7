#pragma once

#include "runtime/interface/measures.h"
#include "runtime/scene/draw_list.h"

namespace docent::interface {

/// How many visitors at most use a glass at the same time.
inline constexpr std::uint32_t most_seats = 8;

/// How many seats a glass has room for, at most `wanted`: each is at least 100 mm wide, and wider
/// where letters are larger. 1: the glass is not shared.
std::uint32_t seats_on(const ScreenShape& shape, std::uint32_t wanted) noexcept;

/// The strip along the lower edge of a shared glass, where the seats are. The model keeps the rest,
/// which is more than 55 %. Screen frame.
scene::Rect strip_of(const ScreenShape& shape) noexcept;

/// The part of the strip that belongs to `seat` (counted from the left, from 1), and the card in
/// its middle. Screen frame.
scene::Rect column_of(const ScreenShape& shape, std::uint32_t seats, std::uint32_t seat) noexcept;
scene::Rect card_of(const ScreenShape& shape, std::uint32_t seats, std::uint32_t seat) noexcept;

}  // namespace docent::interface
