#pragma once

#include <array>
#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <vector>

namespace docent::config {

/// Hours of a week, as OpenStreetMap's opening_hours writes them.
struct WeeklyHours {
  /// Minutes since the midnight that begins the day; `end` may be in the next day.
  struct Span {
    std::int32_t begin = 0, end = 0;
    bool operator==(const Span&) const = default;
  };
  std::array<std::vector<Span>, 7> day;  ///< From Monday on.
  bool operator==(const WeeklyHours&) const = default;
};

/// Reads the part of opening_hours that a week needs: rules that are separated by ';', each of
/// days ("Mo-Fr", "Sa,Su", none: all) and times ("08:30-12:00,13:00-18:00", also past midnight) or
/// "off"; "24/7" is all the time. A later rule replaces an earlier one on its days. The error says
/// what cannot be read.
std::expected<WeeklyHours, std::string> parse_weekly_hours(std::string_view text);

/// Is the minute within the hours? `weekday`: 0 is Monday. `minute`: of that day.
bool holds(const WeeklyHours& hours, int weekday, int minute) noexcept;

}  // namespace docent::config
