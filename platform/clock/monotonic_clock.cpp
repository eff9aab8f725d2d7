#include "platform/clock/monotonic_clock.h"

#include <algorithm>

namespace docent::clock {

std::chrono::nanoseconds monotonic_now() noexcept {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::steady_clock::now().time_since_epoch());
}

std::chrono::duration<float> FrameClock::since_last_frame() noexcept {
  using Seconds = std::chrono::duration<float>;
  constexpr Seconds longest{0.1F};
  const auto now = monotonic_now();
  const Seconds passed = now - last_;
  last_ = now;
  return std::clamp(passed, Seconds::zero(), longest);
}

}  // namespace docent::clock
