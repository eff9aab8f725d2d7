#include "runtime/guide/repose.h"

#include <algorithm>

namespace docent::guide {
namespace {

constexpr float falls_asleep_in = 1, wakes_in = 0.5F;  ///< Seconds.

/// In the middle of a step or a gesture nobody keeps still.
bool is_at_rest(const Avatar& guide) noexcept {
  return has_finished(guide) && guide.manner.gesture == motion::Gesture::None &&
         !holds(guide.manner);
}

}  // namespace

float Repose::step(bool is_asked, const Avatar& guide, float seconds) noexcept {
  awake_ += is_asked && is_at_rest(guide) ? -seconds / falls_asleep_in : seconds / wakes_in;
  awake_ = std::clamp(awake_, 0.0F, 1.0F);
  return share();
}

float Repose::share() const noexcept {
  constexpr float least = 1.0F / 64;  // slower than that nothing is seen to move
  const float share = awake_ * awake_ * (3 - 2 * awake_);
  return share < least ? 0 : share;
}

}  // namespace docent::guide
