#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

#include "runtime/model/hours/opening_hours.h"

namespace docent {

/// The rules of a time zone, as POSIX writes them in TZ: "CET-1CEST,M3.5.0,M10.5.0/3". A device
/// needs no table of zones for them. They hold for the years to come, until a government decides
/// otherwise.
struct TimeZone {
  /// A day of a year and a time of it, by the clock that ends then.
  struct Change {
    enum class Kind : std::uint8_t { MonthWeekDay, JulianDay, DayOfYear };
    Kind kind = Kind::MonthWeekDay;
    int month = 1, week = 1;  ///< MonthWeekDay; week 5 is the last.
    int day = 0;              ///< Weekday, 0 Sunday; or 1 to 365, never 29 February; or 0 to 365.
    std::chrono::seconds time{7200};
  };
  std::chrono::seconds standard{0};  ///< East of Greenwich.
  std::chrono::seconds daylight{0};
  bool has_daylight = false;
  Change begin, end;  ///< Of daylight saving.
};

/// None where it cannot be read.
std::optional<TimeZone> parse_time_zone(std::string_view posix);

/// What a clock on the wall shows.
std::chrono::local_seconds local_time(const TimeZone& zone, std::chrono::sys_seconds at) noexcept;

/// When it shows that: the first time where it does so twice; where it never does (an hour is left
/// out in spring), when as many minutes have passed since the change.
std::chrono::sys_seconds system_time(const TimeZone& zone, std::chrono::local_seconds at) noexcept;

/// The same, to the minute, the later ones left out.
LocalMinute local_minute(const TimeZone& zone, std::chrono::sys_seconds at) noexcept;

}  // namespace docent
