#include "runtime/kiosk/time_for_video.h"

#include <algorithm>

namespace docent::kiosk {

void TimeForVideo::took(double seconds) noexcept {
  // A film has 24 frames a second, and a screen may show one in every second of its sixty.
  constexpr double longest = 0.04, shortest = 0.03;
  recent_[count_++ % looked_at] = seconds;
  if (count_ < looked_at) return;
  // One that was held up by something else says nothing.
  if (std::ranges::min(recent_) > longest) is_short_ = true;
  if (std::ranges::max(recent_) < shortest) is_short_ = false;
}

}  // namespace docent::kiosk
