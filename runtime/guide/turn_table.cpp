#include "runtime/guide/turn_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace docent::guide {
namespace {

constexpr float whole_turn = 2 * std::numbers::pi_v<float>;

float wrapped(float angle) noexcept {
  return std::remainder(angle, whole_turn);
}

}  // namespace

void TurnTable::put(std::optional<std::uint32_t> exhibit) noexcept {
  if (exhibit == exhibit_) return;
  *this = {};
  exhibit_ = exhibit;
}

void TurnTable::turn(bool left) noexcept {
  constexpr float step = whole_turn / 12;
  if (!exhibit_) return;
  is_touched_ = true;
  rate_ = 0;
  left_to_turn_ += left ? -step : step;
}

void TurnTable::step(std::span<const input::Finger> fingers, const scene::Rect& free,
                     float sways_for, float seconds) noexcept {
  if (!exhibit_ || seconds <= 0) return;
  constexpr float dies_away = 0.35F, by_keys = 0.12F;  // seconds
  swayed_for_ += sways_for;
  const auto held = std::ranges::find_if(fingers, [&](const input::Finger& finger) {
    return finger_ ? finger.start.id == *finger_
                   : scene::contains(free, finger.start.x, finger.start.y);
  });
  if (held == fingers.end()) {
    finger_.reset();
  } else {
    if (!finger_) finger_x_ = held->start.x;
    finger_ = held->start.id;
    const float turned = (held->at.x - finger_x_) / std::max(free.width, 0.1F) * whole_turn;
    finger_x_ = held->at.x;
    is_touched_ = is_touched_ || turned != 0;
    left_to_turn_ = 0;
    angle_ = wrapped(angle_ + turned);
    rate_ = std::lerp(rate_, turned / seconds, std::min(1.0F, seconds / 0.05F));
    return;
  }
  const float keys = left_to_turn_ * (1 - std::exp(-seconds / by_keys));
  left_to_turn_ -= keys;
  // A sway of a tenth of a turn shows that it is one of the things that can be turned.
  constexpr float sway = whole_turn / 20, sway_seconds = 9;
  const auto swayed = [&](float at) { return sway * std::sin(whole_turn * at / sway_seconds); };
  const float by_itself = is_touched_ ? 0 : swayed(swayed_for_) - swayed(swayed_for_ - sways_for);
  angle_ = wrapped(angle_ + rate_ * seconds + keys + by_itself);
  rate_ *= std::exp(-seconds / dies_away);
  if (std::abs(rate_) < 0.01F) rate_ = 0;
}

bool has_object(const Museum& museum, std::optional<std::uint32_t> exhibit) noexcept {
  return exhibit && *exhibit < museum.exhibits.size() && museum.exhibits[*exhibit].object >= 0;
}

Vec3 foot_of(const Museum& museum, const Exhibit& exhibit) noexcept {
  return to_world(exhibit.stand.position,
                  museum.floors[exhibit.floor].plan.height + exhibit.stand.base);
}

Vec3 size_of(const Museum& museum, const Exhibit& exhibit) noexcept {
  return static_cast<float>(exhibit.stand.scale) *
         museum.objects[static_cast<std::size_t>(exhibit.object)].size;
}

void draw_objects(const Museum& museum, std::uint32_t floor, const TurnTable& table,
                  std::optional<std::uint32_t> near, scene::DrawList& list) noexcept {
  constexpr float highlighted = 0.15F;
  list.objects.clear();
  list.near_object.reset();
  for (std::uint32_t i = 0; i < museum.exhibits.size(); ++i) {
    const Exhibit& exhibit = museum.exhibits[i];
    if (exhibit.object < 0 || exhibit.floor != floor ||
        list.objects.size() == list.objects.capacity())
      continue;
    const float turned = table.exhibit() == i ? table.angle() : 0;
    list.objects.push_back({.object = static_cast<std::uint32_t>(exhibit.object),
                            .foot = foot_of(museum, exhibit),
                            .heading = static_cast<float>(exhibit.placement.heading) + turned,
                            .scale = static_cast<float>(exhibit.stand.scale),
                            .glow = list.highlighted_exhibit == i ? highlighted : 0});
    if (near == i) list.near_object = static_cast<std::uint32_t>(exhibit.object);
  }
}

}  // namespace docent::guide
