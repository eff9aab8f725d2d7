#pragma once

#include "runtime/interface/measures.h"
#include "runtime/scene/draw_list.h"

namespace docent::interface {

/// How many visitors at most use a glass at the same time.
inline constexpr std::uint32_t most_seats = 8;

/// How many seats a glass has room for, at most `wanted`: each is at least 100 mm wide, and so wide
/// that six rows of the list are seen on its card, whatever the size of letters. A side that is too
/// short for that has none. 1: the glass is not shared.
std::uint32_t seats_on(const ScreenShape& shape, std::uint32_t wanted) noexcept;

/// What the strips of seats along the edges leave to the model, which is at least 55 %. Screen
/// frame.
scene::Rect model_of(const ScreenShape& shape) noexcept;

/// At which edge a seat is. They are counted from 1: along the lower edge from the left, and on
/// round the glass, each edge from its left as those see it who stand there.
scene::Side side_of(const ScreenShape& shape, std::uint32_t seats, std::uint32_t seat) noexcept;

/// The glass as it is seen from a side.
ScreenShape seen_from(scene::Side side, const ScreenShape& shape) noexcept;

/// The part of the strip that belongs to `seat`, and the card in its middle. Frame: the glass as
/// it is seen from the seat's side.
scene::Rect column_of(const ScreenShape& shape, std::uint32_t seats, std::uint32_t seat) noexcept;
scene::Rect card_of(const ScreenShape& shape, std::uint32_t seats, std::uint32_t seat) noexcept;

}  // namespace docent::interface
