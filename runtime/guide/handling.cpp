/// What a visitor's fingers do to the model, rather than press.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "runtime/guide/session.h"

namespace docent::guide {

// What the visitor turns.

void Session::turn_object(float seconds, float liveliness) noexcept {
  const bool is_before_it = state_.screen == interface::Screen::Arrived &&
                            state_.glass == interface::Glass::Whole &&
                            has_object(context_.museum, state_.exhibit);
  // What a hand may lie on keeps still for it.
  const bool swings = is_before_it && !context_.reduced_motion &&
                      context_.museum.exhibits[*state_.exhibit].touches.empty();
  table_.put(is_before_it ? state_.exhibit : std::nullopt);
  if (is_before_it && view() != nullptr)
    table_.step(gestures_.fingers(), view()->free, swings ? liveliness * seconds : 0, seconds);
}

/// Did a finger turn the object, and so press nothing?
bool Session::has_turned(const input::Finger& finger) const noexcept {
  constexpr float far = 0.02F;
  return table_.exhibit() && view() != nullptr &&
         scene::contains(view()->free, finger.start.x, finger.start.y) &&
         std::abs(finger.at.x - finger.start.x) > far;
}

// What the visitor draws nearer.

void Session::look_closer(const WholeModel& model, float aspect, float seconds) noexcept {
  constexpr float left_after = 20;  // seconds without a touch, where nobody has begun
  if (!interface::shows_spots(state_.screen) || view() == nullptr) return closer_.end(true);
  // Of another screen or floor all is seen first.
  const std::pair shown{state_.screen, model.rig.target.y};
  if (shown != looked_at_) closer_.end(true);
  looked_at_ = shown;
  std::array<input::Finger, 2> fingers;
  std::size_t count = 0;
  for (const input::Finger& finger : gestures_.fingers())
    if (count < fingers.size() && overlay_.is_on_model(finger.start.x, finger.start.y))
      fingers[count++] = finger;
  let_be_seconds_ = count > 0 ? 0 : let_be_seconds_ + seconds;
  if (state_.asks_to_stay || (is_vacant() && let_be_seconds_ > left_after)) closer_.end(false);
  closer_.step(std::span(fingers).first(count), model, aspect, seconds);
}

}  // namespace docent::guide
