#include "runtime/guide/seating.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "runtime/interface/seats.h"

namespace docent::guide {
namespace {

constexpr float arms_reach = 600;       // millimetres of glass that one visitor covers
constexpr float reach_up = 0.3F;        // of a millimetre upwards, what it counts to the side
constexpr float strays_columns = 1.5F;  // a territory that far from its card draws it along

}  // namespace

std::optional<std::size_t> Seating::part_of(std::uint32_t seat) const noexcept {
  for (std::size_t part = 1; part < sessions_.size(); ++part)
    if (sessions_[part].state().seat == seat) return part;
  return {};
}

bool Seating::is_on_model(scene::ScreenPoint at) const noexcept {
  return at.y < interface::strip_of(shape_).y;
}

void Seating::touch(std::size_t part, scene::ScreenPoint at) noexcept {
  scene::ScreenPoint& territory = territory_[part];
  territory = sessions_[part].is_vacant() ? at
                                          : scene::ScreenPoint{std::midpoint(territory.x, at.x),
                                                               std::midpoint(territory.y, at.y)};
  if (is_on_model(at)) follow_territory(part);
}

void Seating::press_key(std::size_t part) noexcept {
  if (!sessions_[part].is_vacant()) return;
  const scene::Rect card = interface::card_of(shape_, static_cast<std::uint32_t>(seats()),
                                              *sessions_[part].state().seat);
  territory_[part] = {card.x + card.width / 2, card.y + card.height / 2};
}

std::size_t Seating::visitor_at(scene::ScreenPoint at) const noexcept {
  if (!is_on_model(at)) return seat_at(at.x);
  std::size_t nearest = 0;
  const std::size_t vacant = vacant_seat_near(at.x);
  float distance = vacant > 0 ? std::min(arms_reach, 2 * column_millimetres()) : arms_reach;
  for (std::size_t part = 1; part < sessions_.size(); ++part) {
    const float mm = millimetres(territory_[part], at);
    if (sessions_[part].is_vacant() || mm > distance) continue;
    distance = mm;
    nearest = part;
  }
  return nearest > 0 ? nearest : vacant;
}

std::size_t Seating::seat_at(float x) const noexcept {
  const auto count = static_cast<float>(seats());
  const auto seat = static_cast<std::uint32_t>(std::clamp(x * count, 0.0F, count - 1));
  return part_of(seat + 1).value_or(0);
}

/// From the left edge to the middle of its seat, in seats' widths.
float Seating::column_middle(std::size_t part) const noexcept {
  return static_cast<float>(*sessions_[part].state().seat) - 0.5F;
}

std::size_t Seating::vacant_seat_near(float x) const noexcept {
  std::size_t nearest = 0;
  float distance = 2;
  for (std::size_t part = 1; part < sessions_.size(); ++part) {
    const float middle = column_middle(part) / static_cast<float>(seats());
    if (!sessions_[part].is_vacant() || std::abs(middle - x) >= distance) continue;
    distance = std::abs(middle - x);
    nearest = part;
  }
  return nearest;
}

/// Who stands before a glass reaches up further than to the side.
float Seating::millimetres(scene::ScreenPoint a, scene::ScreenPoint b) const noexcept {
  const float across = (a.x - b.x) * static_cast<float>(shape_.width);
  const float down = (a.y - b.y) * static_cast<float>(shape_.height);
  return std::hypot(across, reach_up * down) / interface::measures_of(shape_).mm;
}

float Seating::column_millimetres() const noexcept {
  return static_cast<float>(shape_.width) / static_cast<float>(seats()) /
         interface::measures_of(shape_).mm;
}

/// The card of a visitor who has gone on along the glass comes after them, if there is a seat.
void Seating::follow_territory(std::size_t part) noexcept {
  const std::size_t other = vacant_seat_near(territory_[part].x);
  if (other == 0 || sessions_[part].is_vacant()) return;
  const auto columns_off = [&](std::size_t of) {
    return std::abs(territory_[part].x * static_cast<float>(seats()) - column_middle(of));
  };
  if (columns_off(part) < strays_columns || columns_off(other) + 1 > columns_off(part)) return;
  interface::InterfaceState mine = sessions_[part].state(), theirs = sessions_[other].state();
  std::swap(mine.seat, theirs.seat);
  sessions_[part].show(mine);
  sessions_[other].show(theirs);
}

}  // namespace docent::guide
