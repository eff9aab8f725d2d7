#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace docent {

/// A minute of the calendar and clock on the museum's wall.
using LocalMinute = std::chrono::local_time<std::chrono::minutes>;

/// Days of the calendar, ends included: of one year, or of every year where it says none.
struct DateRange {
  /// A part that is 0 is not said: a month as a whole, a year as a whole.
  struct Date {
    int year = 0;
    unsigned month = 0, day = 0;
    bool operator==(const Date&) const = default;
  };
  Date from{}, to{};  ///< Both have a year, or neither; of every year they may go round its end.
  bool has_end = true;

  bool holds(std::chrono::year_month_day date) const noexcept;
  bool operator==(const DateRange&) const = default;
};

/// When something is open: a subset of OpenStreetMap's opening_hours, which museum.toml(5) lists.
///
/// Rules are looked at in order; of those that hold on a day the last one says its times. Times
/// that go past midnight belong to the day on which they begin. A rule that is "off" at given times
/// takes just those away.
struct OpeningHours {
  static constexpr std::int32_t day_minutes = 24 * 60;

  /// Minutes since the midnight that begins a day: 0 <= begin < 24 h, begin < end <= begin + 24 h.
  struct Span {
    std::int32_t begin = 0, end = 0;
    bool operator==(const Span&) const = default;
  };
  struct Rule {
    /// Which of a month's Mondays, Tuesdays and so on: bits 0 to 4 the first to the fifth, bits 5
    /// to 9 the last to the last but four.
    static constexpr std::uint16_t every = 0x3FF;

    std::vector<DateRange> dates;             ///< None: all.
    std::array<std::uint16_t, 7> weekdays{};  ///< From Monday on.
    bool holidays = false;                    ///< Public holidays beside those days.
    std::vector<Span> spans;                  ///< None: the whole day.
    bool is_off = false;
    bool operator==(const Rule&) const = default;
  };
  std::vector<Rule> rules;

  bool operator==(const OpeningHours&) const = default;
};

/// Why hours cannot be read.
struct HoursError {
  std::size_t column = 1;  ///< Of the text, in characters, from 1.
  std::string what, hint;
};

std::expected<OpeningHours, HoursError> parse_opening_hours(std::string_view text);

/// Dates as opening_hours writes them, with commas between: "Dec 25,26,2027 Mar 26-29".
std::expected<std::vector<DateRange>, HoursError> parse_dates(std::string_view text);

/// Are they open at a minute? `holidays`: the public holidays.
bool is_open(const OpeningHours& hours, std::span<const DateRange> holidays,
             LocalMinute at) noexcept;

/// The first minute after `at` that is not as `at` is: open where that is closed, and the other way
/// round. None within two years.
std::optional<LocalMinute> next_change(const OpeningHours& hours,
                                       std::span<const DateRange> holidays, LocalMinute at);

}  // namespace docent
