#include "platform/clock/monotonic_clock.h"

#include <utility>

namespace docent::clock {

std::chrono::nanoseconds monotonic_now() noexcept {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::steady_clock::now().time_since_epoch());
}

std::chrono::nanoseconds FrameClock::since_last_frame() noexcept {
  const auto now = monotonic_now();
  return now - std::exchange(last_, now);
}

}  // namespace docent::clock
