#pragma once

#include <chrono>
#include <optional>

#include "config/weekly_hours.h"

namespace docent::kiosk {

/// A minute of a week, in the time of the place.
struct LocalMinute {
  int weekday = 0;  ///< 0 is Monday.
  int minute = 0;   ///< Of the day.
};
LocalMinute local_minute() noexcept;

/// When the screen is lit: in its hours, and outside them for some time after a touch.
class ScreenHours {
 public:
  /// Without hours the screen is always lit. Borrows them.
  ScreenHours(const std::optional<config::WeeklyHours>& hours,
              std::chrono::seconds after_touch) noexcept;

  bool are_set() const noexcept { return hours_ != nullptr; }
  /// Is it to be lit? `passed`: seconds since the last call. `is_touched`: somebody is there.
  bool is_lit(LocalMinute now, double passed, bool is_touched) noexcept;

 private:
  const config::WeeklyHours* hours_;
  std::chrono::duration<double> after_touch_;
  double lit_for_ = 0;  ///< Seconds that are left after a touch.
};

}  // namespace docent::kiosk
