#include "runtime/guide/seating.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "runtime/interface/seats.h"
#include "runtime/scene/side.h"

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
  return scene::contains(interface::model_of(shape_), at.x, at.y);
}

scene::Side Seating::side_of(std::size_t part) const noexcept {
  return interface::side_of(shape_, static_cast<std::uint32_t>(seats()),
                            *sessions_[part].state().seat);
}

/// As it is seen from its side.
scene::Rect Seating::column_of(std::size_t part) const noexcept {
  return interface::column_of(shape_, static_cast<std::uint32_t>(seats()),
                              *sessions_[part].state().seat);
}

scene::ScreenPoint Seating::middle_of_card(std::size_t part) const noexcept {
  const scene::Rect column = column_of(part);
  return scene::to_screen(
      side_of(part), scene::ScreenPoint{column.x + column.width / 2, column.y + column.height / 2});
}

void Seating::touch(std::size_t part, scene::ScreenPoint at) noexcept {
  scene::ScreenPoint& territory = territory_[part];
  territory = sessions_[part].is_vacant() ? at
                                          : scene::ScreenPoint{std::midpoint(territory.x, at.x),
                                                               std::midpoint(territory.y, at.y)};
  if (is_on_model(at)) follow_territory(part);
}

void Seating::press_key(std::size_t part) noexcept {
  if (sessions_[part].is_vacant()) territory_[part] = middle_of_card(part);
}

std::size_t Seating::visitor_at(scene::ScreenPoint at) const noexcept {
  if (!is_on_model(at)) return seat_at(at);
  std::size_t nearest = 0;
  const std::size_t vacant = vacant_seat_near(at);
  float distance = vacant > 0 ? std::min(arms_reach, 2 * column_millimetres(vacant)) : arms_reach;
  for (std::size_t part = 1; part < sessions_.size(); ++part) {
    const float mm = millimetres(part, territory_[part], at, reach_up);
    if (sessions_[part].is_vacant() || mm > distance) continue;
    distance = mm;
    nearest = part;
  }
  return nearest > 0 ? nearest : vacant;
}

std::size_t Seating::other_visitor_at(scene::ScreenPoint at, std::size_t than) const noexcept {
  std::size_t nearest = 0;
  float distance = 1e9F;
  for (std::size_t part = 1; part < sessions_.size(); ++part) {
    const float mm = millimetres(part, territory_[part], at, reach_up);
    if (part == than || !sessions_[part].guide() || mm > distance) continue;
    distance = mm;
    nearest = part;
  }
  return nearest;
}

/// Whose column is nearest: at a corner two strips meet.
std::size_t Seating::seat_at(scene::ScreenPoint at) const noexcept {
  std::size_t nearest = 0;
  float distance = 1e9F;
  for (std::size_t part = 1; part < sessions_.size(); ++part) {
    const scene::Rect column = column_of(part);
    const scene::ScreenPoint seen = scene::as_seen_from(side_of(part), at);
    const scene::ScreenPoint within{std::clamp(seen.x, column.x, column.x + column.width),
                                    std::clamp(seen.y, column.y, column.y + column.height)};
    const float mm = millimetres(part, scene::to_screen(side_of(part), within), at, 1);
    if (mm >= distance) continue;
    distance = mm;
    nearest = part;
  }
  return nearest;
}

std::size_t Seating::vacant_seat_near(scene::ScreenPoint at) const noexcept {
  std::size_t nearest = 0;
  float distance = 1e9F;
  for (std::size_t part = 1; part < sessions_.size(); ++part) {
    const float mm = millimetres(part, middle_of_card(part), at, 1);
    if (!sessions_[part].is_vacant() || mm >= distance) continue;
    distance = mm;
    nearest = part;
  }
  return nearest;
}

/// Who stands before a glass reaches up further than to the side: what a millimetre away from the
/// part's side counts, of one along it.
float Seating::millimetres(std::size_t part, scene::ScreenPoint a, scene::ScreenPoint b,
                           float up) const noexcept {
  const float across = (a.x - b.x) * static_cast<float>(shape_.width);
  const float down = (a.y - b.y) * static_cast<float>(shape_.height);
  const bool is_at_end = scene::is_at_end(side_of(part));
  return std::hypot(is_at_end ? up * across : across, is_at_end ? down : up * down) /
         interface::measures_of(shape_).mm;
}

float Seating::column_millimetres(std::size_t part) const noexcept {
  const bool is_at_end = scene::is_at_end(side_of(part));
  return column_of(part).width * static_cast<float>(is_at_end ? shape_.height : shape_.width) /
         interface::measures_of(shape_).mm;
}

/// How far to the side of its column that is, in columns.
float Seating::columns_off(std::size_t part, scene::ScreenPoint at) const noexcept {
  const scene::Rect column = column_of(part);
  return std::abs(scene::as_seen_from(side_of(part), at).x - column.x - column.width / 2) /
         column.width;
}

/// The card of a visitor who has gone on along their side of the glass comes after them, if there
/// is a seat.
void Seating::follow_territory(std::size_t part) noexcept {
  const scene::ScreenPoint at = territory_[part];
  const std::size_t other = vacant_seat_near(at);
  if (other == 0 || sessions_[part].is_vacant() || side_of(part) != side_of(other)) return;
  if (columns_off(part, at) < strays_columns || columns_off(other, at) + 1 > columns_off(part, at))
    return;
  interface::InterfaceState mine = sessions_[part].state(), theirs = sessions_[other].state();
  std::swap(mine.seat, theirs.seat);
  sessions_[part].show(mine);
  sessions_[other].show(theirs);
}

}  // namespace docent::guide
