#include "runtime/input/gesture.h"

#include <algorithm>
#include <cmath>

namespace docent::input {
namespace {

/// A flick ends within this time, and goes mostly sideways.
constexpr float flick_seconds = 0.6F;

Gesture::Kind meaning_of(const Finger& finger, float flick_distance) noexcept {
  const float across = finger.at.x - finger.start.x, down = finger.at.y - finger.start.y;
  const bool flicked = finger.seconds <= flick_seconds && std::abs(across) >= flick_distance &&
                       std::abs(across) > 2 * std::abs(down);
  if (!flicked) return Gesture::Kind::Release;
  return across < 0 ? Gesture::Kind::SwipeLeft : Gesture::Kind::SwipeRight;
}

}  // namespace

Finger* GestureRecogniser::find(std::uint32_t id) noexcept {
  const auto end = fingers_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto found =
      std::find_if(fingers_.begin(), end, [id](const Finger& f) { return f.at.id == id; });
  return found == end ? nullptr : &*found;
}

std::optional<Gesture> GestureRecogniser::take(const InputEvent& event) noexcept {
  Finger* finger = find(event.contact.id);
  switch (event.kind) {
    case InputEvent::Kind::Down:
      if (finger == nullptr && count_ < most_fingers) finger = &fingers_[count_++];
      if (finger != nullptr) *finger = {event.contact, event.contact, 0};
      break;
    case InputEvent::Kind::Move:
      if (finger != nullptr) finger->at = event.contact;
      break;
    case InputEvent::Kind::Up: {
      if (finger == nullptr) break;
      const Gesture gesture{meaning_of(*finger, flick_distance_), *finger};
      *finger = fingers_[--count_];
      return gesture;
    }
    case InputEvent::Kind::Cancel:
      if (finger != nullptr) *finger = fingers_[--count_];
      break;
    case InputEvent::Kind::KeyDown:
    case InputEvent::Kind::KeyUp:
      break;
  }
  return std::nullopt;
}

void GestureRecogniser::advance(float seconds) noexcept {
  for (std::size_t i = 0; i < count_; ++i) fingers_[i].seconds += seconds;
}

}  // namespace docent::input
