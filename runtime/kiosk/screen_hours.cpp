#include "runtime/kiosk/screen_hours.h"

#include <algorithm>
#include <ctime>

namespace docent::kiosk {

LocalMinute local_minute() noexcept {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  return {(local.tm_wday + 6) % 7, local.tm_hour * 60 + local.tm_min};
}

ScreenHours::ScreenHours(const std::optional<config::WeeklyHours>& hours,
                         std::chrono::seconds after_touch) noexcept
    : hours_(hours ? &*hours : nullptr), after_touch_(after_touch) {
  if (hours_ != nullptr) tzset();  // takes memory, which a frame may not
}

bool ScreenHours::is_lit(LocalMinute now, double passed, bool is_touched) noexcept {
  if (hours_ == nullptr) return true;
  lit_for_ = is_touched ? after_touch_.count() : std::max(0.0, lit_for_ - passed);
  return lit_for_ > 0 || config::holds(*hours_, now.weekday, now.minute);
}

}  // namespace docent::kiosk
