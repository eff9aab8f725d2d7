#include "runtime/model/hours/opening_hours.h"

#include <algorithm>

namespace docent {
namespace {

namespace chr = std::chrono;

/// Year, month and day in one number that orders as they do.
int in_order(int year, unsigned month, unsigned day) noexcept {
  return year * 10000 + static_cast<int>(month * 100 + day);
}

/// Which of its month's weekdays of its kind a date is, as bits of Rule::weekdays.
std::uint16_t place_in_month(chr::year_month_day date) noexcept {
  const auto last = static_cast<unsigned>((date.year() / date.month() / chr::last).day());
  const auto day = static_cast<unsigned>(date.day());
  return static_cast<std::uint16_t>(1U << ((day - 1) / 7) | 1U << (5 + (last - day) / 7));
}

/// A day as rules see it.
struct Day {
  Day(chr::local_days of, std::span<const DateRange> holidays) noexcept
      : date(of),
        weekday(chr::weekday(of).iso_encoding() - 1),
        place(place_in_month(date)),
        is_holiday(std::ranges::any_of(
            holidays, [&](const DateRange& range) { return range.holds(date); })) {}

  bool has(const OpeningHours::Rule& rule) const noexcept {
    const bool dated =
        rule.dates.empty() ||
        std::ranges::any_of(rule.dates, [&](const DateRange& range) { return range.holds(date); });
    return dated && ((rule.weekdays[weekday] & place) != 0 || (rule.holidays && is_holiday));
  }

  chr::year_month_day date;
  unsigned weekday;
  std::uint16_t place;
  bool is_holiday;
};

bool covers(const OpeningHours::Rule& rule, std::int32_t minute) noexcept {
  if (rule.spans.empty()) return minute < OpeningHours::day_minutes;
  return std::ranges::any_of(rule.spans, [=](const OpeningHours::Span& span) {
    return span.begin <= minute && minute < span.end;
  });
}

}  // namespace

bool DateRange::holds(chr::year_month_day date) const noexcept {
  const auto day = static_cast<unsigned>(date.day()), month = static_cast<unsigned>(date.month());
  const int year = static_cast<int>(date.year());
  const bool is_dated = from.year != 0;
  const int at = in_order(is_dated ? year : 0, month, day);
  const int first = in_order(from.year, std::max(from.month, 1U), std::max(from.day, 1U));
  if (!has_end) return at >= first;
  const int last = in_order(to.year, to.month == 0 ? 12 : to.month, to.day == 0 ? 31 : to.day);
  if (!is_dated && first > last) return at >= first || at <= last;
  return first <= at && at <= last;
}

bool is_open(const OpeningHours& hours, std::span<const DateRange> holidays,
             LocalMinute at) noexcept {
  const auto today = chr::floor<chr::days>(at);
  const auto minute = static_cast<std::int32_t>((at - today).count());
  const Day day(today, holidays), day_before(today - chr::days(1), holidays);
  bool open_today = false, open_since_yesterday = false;
  for (const OpeningHours::Rule& rule : hours.rules) {
    const bool holds_now = day.has(rule) && covers(rule, minute);
    const bool held_over = day_before.has(rule) && covers(rule, minute + OpeningHours::day_minutes);
    if (rule.is_off && !rule.spans.empty()) {
      if (holds_now || held_over) open_today = open_since_yesterday = false;
      continue;
    }
    if (day.has(rule)) open_today = holds_now && !rule.is_off;
    if (day_before.has(rule)) open_since_yesterday = held_over && !rule.is_off;
  }
  return open_today || open_since_yesterday;
}

std::optional<LocalMinute> next_change(const OpeningHours& hours,
                                       std::span<const DateRange> holidays, LocalMinute at) {
  constexpr int farthest = 2 * 366;      // days
  std::vector<std::int32_t> minutes{0};  // of a day, at which anything can begin or end
  for (const OpeningHours::Rule& rule : hours.rules)
    for (const OpeningHours::Span& span : rule.spans)
      for (const std::int32_t minute : {span.begin, span.end})
        minutes.push_back(minute % OpeningHours::day_minutes);
  std::ranges::sort(minutes);
  minutes.erase(std::ranges::unique(minutes).begin(), minutes.end());

  const bool now = is_open(hours, holidays, at);
  const auto today = chr::floor<chr::days>(at);
  for (int day = 0; day <= farthest; ++day)
    for (const std::int32_t minute : minutes) {
      const LocalMinute next = today + chr::days(day) + chr::minutes(minute);
      if (next > at && is_open(hours, holidays, next) != now) return next;
    }
  return std::nullopt;
}

}  // namespace docent
