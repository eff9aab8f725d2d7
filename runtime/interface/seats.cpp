#include "runtime/interface/seats.h"

#include <algorithm>
#include <cmath>

namespace docent::interface {
namespace {

constexpr float least_mm = 100, least_units = 26;  // of a seat's width
constexpr float most_units = 60;                   // of a card's width, and of the strip's height
constexpr float most_height = 0.42F;               // of the strip, as a share of the glass

}  // namespace

std::uint32_t seats_on(const ScreenShape& shape, std::uint32_t wanted) noexcept {
  const Measures m = measures_of(shape);
  const float least = std::max(least_mm * m.mm, least_units * m.unit) * shape.text_scale;
  const auto room = static_cast<std::uint32_t>(static_cast<float>(shape.width) / least);
  return std::clamp(wanted, 1U, std::clamp(room, 1U, most_seats));
}

scene::Rect strip_of(const ScreenShape& shape) noexcept {
  const auto height = static_cast<float>(shape.height);
  const float strip =
      std::round(std::min(most_height * height, most_units * measures_of(shape).unit)) / height;
  return {0, 1 - strip, 1, strip};
}

scene::Rect column_of(const ScreenShape& shape, std::uint32_t seats, std::uint32_t seat) noexcept {
  const scene::Rect strip = strip_of(shape);
  const float width = 1 / static_cast<float>(seats);
  return {static_cast<float>(seat - 1) * width, strip.y, width, strip.height};
}

scene::Rect card_of(const ScreenShape& shape, std::uint32_t seats, std::uint32_t seat) noexcept {
  const auto width = static_cast<float>(shape.width), height = static_cast<float>(shape.height);
  const Measures m = measures_of(shape);
  const scene::Rect column = column_of(shape, seats, seat);
  const float gap = std::round(m.unit);
  const float wide = std::floor(std::min(column.width * width - gap, most_units * m.unit));
  const float left = std::round(column.x * width + (column.width * width - wide) / 2);
  return {left / width, column.y + gap / height, wide / width,
          column.height - (gap + m.gap) / height};
}

}  // namespace docent::interface
