#include "runtime/interface/seats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "runtime/scene/side.h"

namespace docent::interface {
namespace {

using scene::Side;

constexpr float least_mm = 100, least_units = 26;              // of a seat's width
constexpr float shallow_mm = 150, least_shallow_mm = 235;      // where a strip is less deep
constexpr float most_card_mm = 340, most_strip_mm = 280;       // of a card's width, a strip's depth
constexpr float most_of_hanging = 0.42F, most_taken = 0.445F;  // of the glass, by strips

/// In which order seats go round the glass.
constexpr std::array round{Side::Bottom, Side::Right, Side::Top, Side::Left};

/// The strips' depth in pixels: of all the same, so that they take so much of the glass at most.
float depth_at(const ScreenShape& shape, Sides sides) noexcept {
  const auto width = static_cast<float>(shape.width), height = static_cast<float>(shape.height);
  const auto at = [&](Side side) { return sides.has(side) ? 1.0F : 0.0F; };
  const float ends = at(Side::Left) + at(Side::Right),
              long_sides = at(Side::Bottom) + at(Side::Top);
  // (width - ends * d) * (height - long_sides * d) is what is left, and corners are taken once.
  const float taken = (shape.sides.is_table() ? most_taken : most_of_hanging) * width * height;
  const float b = ends * height + long_sides * width, a = ends * long_sides;
  const float depth = a > 0 ? (b - std::sqrt(b * b - 4 * a * taken)) / (2 * a) : taken / b;
  return std::floor(std::min(depth, most_strip_mm * measures_of(shape).mm));
}

/// Where a side's strip begins and ends, in pixels from the left as it is seen from there. Those of
/// the lower and the upper edge have the corners.
std::pair<float, float> ends_of_strip(const ScreenShape& shape, Sides sides, Side side) noexcept {
  if (!scene::is_at_end(side)) return {0, static_cast<float>(shape.width)};
  const float depth = depth_at(shape, sides);
  const float top = sides.has(Side::Top) ? depth : 0, bottom = sides.has(Side::Bottom) ? depth : 0;
  const auto height = static_cast<float>(shape.height);
  return side == Side::Left ? std::pair{top, height - bottom} : std::pair{bottom, height - top};
}

float length_of_strip(const ScreenShape& shape, Sides sides, Side side) noexcept {
  const auto [begin, end] = ends_of_strip(shape, sides, side);
  return end - begin;
}

constexpr float none_is_enough = 1e9F;

/// How wide a card of that depth has to be so that six rows of the list are seen on it, with all
/// that it has besides: below each other, or the list in columns beside the rest. In pixels.
float least_for_list(const ScreenShape& shape, float depth) noexcept {
  constexpr float rows = 6, helps = 6, row_units = 8, column_mm = 104, words_mm = 88;
  constexpr float longer = 0.8F;  // of a row: some names take more lines than their picture is high
  const Measures m = measures_of(shape);
  const float scale = shape.text_scale, one = m.touch + m.unit, margins = 5 * m.unit;
  const float row = std::max(m.touch, scale * row_units * m.unit) + m.unit / 2;
  const float column = scale * column_mm * m.mm, words = scale * words_mm * m.mm;
  const float room_below = depth - 7 * m.unit, room_beside = depth - 5 * m.unit;
  float least = none_is_enough;
  for (const float in_row : {3.0F, helps}) {
    const float helped = std::ceil(helps / in_row) * one, wide = in_row * one;
    // Below: languages, pages, and what leads away.
    if (helped + (rows + longer) * row + 3 * one + m.gap <= room_below)
      least = std::min(least, margins + std::max(wide, scale * least_mm * m.mm));
    if (helped + 2 * one > room_beside) continue;
    const float pages = helped + 3 * one > room_beside ? one : 0;  // beside the list
    const float start = std::max(wide, words) + m.gap + margins + pages;
    for (const float columns : {1.0F, 2.0F, 3.0F})
      if ((std::ceil(rows / columns) + longer) * row <= room_beside)
        least = std::min(least, start + columns * (m.gap + column));
  }
  return least;
}

/// How wide a seat is at least.
float least_of_seat(const ScreenShape& shape, float depth) noexcept {
  const Measures m = measures_of(shape);
  const bool is_shallow = shape.sides.is_table() && depth < shallow_mm * m.mm;
  const float usual =
      std::max((is_shallow ? least_shallow_mm : least_mm) * m.mm, least_units * m.unit);
  return std::max(usual * shape.text_scale, least_for_list(shape, depth));
}

/// How many seats a side has room for.
std::uint32_t room_at(const ScreenShape& shape, Sides sides, Side side) noexcept {
  if (!sides.has(side)) return 0;
  const float least = least_of_seat(shape, depth_at(shape, sides));
  return static_cast<std::uint32_t>(std::max(0.0F, length_of_strip(shape, sides, side) / least));
}

/// Where seats are: a side that is too short for one leaves its strip to the model and the others.
Sides sides_of(const ScreenShape& shape) noexcept {
  Sides asked = shape.sides;
  if (asked.count() == 0) asked.add(Side::Bottom);
  for (Sides sides = asked;;) {
    Sides with_room;
    for (const Side side : round)
      if (room_at(shape, sides, side) > 0) with_room.add(side);
    if (with_room == sides) return sides;
    if (with_room.count() == 0) return asked;
    sides = with_room;
  }
}

float depth_of(const ScreenShape& shape) noexcept {
  return depth_at(shape, sides_of(shape));
}

/// Of so many seats, those of each side: who comes next sits where most is free.
std::array<std::uint32_t, 4> seats_by_side(const ScreenShape& shape, std::uint32_t seats) noexcept {
  std::array<std::uint32_t, 4> count{};
  const Sides sides = sides_of(shape);
  for (std::uint32_t i = 0; i < seats; ++i) {
    const auto free_at = [&](Side side) {
      const std::uint32_t taken = count[static_cast<std::size_t>(side)];
      const float width = length_of_strip(shape, sides, side) / static_cast<float>(taken + 1);
      return std::tuple{sides.has(side), taken < room_at(shape, sides, side), width};
    };
    ++count[static_cast<std::size_t>(*std::ranges::max_element(round, {}, free_at))];
  }
  return count;
}

/// A seat's place at its side.
struct SeatPlace {
  Side side = Side::Bottom;
  std::uint32_t index = 0, count = 1;  ///< From the left; of how many.
};
SeatPlace place_of(const ScreenShape& shape, std::uint32_t seats, std::uint32_t seat) noexcept {
  const auto count = seats_by_side(shape, seats);
  std::uint32_t index = seat - 1;
  for (const Side side : round) {
    const std::uint32_t here = count[static_cast<std::size_t>(side)];
    if (index < here) return {side, index, here};
    index -= here;
  }
  return {};
}

}  // namespace

std::uint32_t seats_on(const ScreenShape& shape, std::uint32_t wanted) noexcept {
  std::uint32_t room = 0;
  const Sides sides = sides_of(shape);
  for (const Side side : round) room += room_at(shape, sides, side);
  return std::clamp(wanted, 1U, std::clamp(room, 1U, most_seats));
}

scene::Rect model_of(const ScreenShape& shape) noexcept {
  const Sides sides = sides_of(shape);
  const float x = depth_of(shape) / static_cast<float>(shape.width),
              y = depth_of(shape) / static_cast<float>(shape.height);
  const float left = sides.has(Side::Left) ? x : 0, right = sides.has(Side::Right) ? x : 0;
  const float top = sides.has(Side::Top) ? y : 0, bottom = sides.has(Side::Bottom) ? y : 0;
  return {left, top, 1 - left - right, 1 - top - bottom};
}

Side side_of(const ScreenShape& shape, std::uint32_t seats, std::uint32_t seat) noexcept {
  return place_of(shape, seats, seat).side;
}

ScreenShape seen_from(Side side, const ScreenShape& shape) noexcept {
  ScreenShape seen = shape;
  if (scene::is_at_end(side)) std::swap(seen.width, seen.height);
  return seen;
}

scene::Rect column_of(const ScreenShape& shape, std::uint32_t seats, std::uint32_t seat) noexcept {
  const SeatPlace place = place_of(shape, seats, seat);
  const ScreenShape seen = seen_from(place.side, shape);
  const auto width = static_cast<float>(seen.width), height = static_cast<float>(seen.height);
  const auto [begin, end] = ends_of_strip(shape, sides_of(shape), place.side);
  const float one = (end - begin) / static_cast<float>(place.count), depth = depth_of(shape);
  return {(begin + static_cast<float>(place.index) * one) / width, 1 - depth / height, one / width,
          depth / height};
}

scene::Rect card_of(const ScreenShape& shape, std::uint32_t seats, std::uint32_t seat) noexcept {
  const ScreenShape seen = seen_from(side_of(shape, seats, seat), shape);
  const auto width = static_cast<float>(seen.width), height = static_cast<float>(seen.height);
  const Measures m = measures_of(shape);
  const scene::Rect column = column_of(shape, seats, seat);
  const float gap = std::round(m.unit);
  const float most = std::max(most_card_mm * m.mm, least_of_seat(shape, depth_of(shape)) - gap);
  const float wide = std::floor(std::min(column.width * width - gap, most));
  const float left = std::round(column.x * width + (column.width * width - wide) / 2);
  return {left / width, column.y + gap / height, wide / width,
          column.height - (gap + m.gap) / height};
}

}  // namespace docent::interface
