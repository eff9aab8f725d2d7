#include "config/weekly_hours.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace docent::config {
namespace {

constexpr std::array<std::string_view, 7> day_names{"Mo", "Tu", "We", "Th", "Fr", "Sa", "Su"};
constexpr std::int32_t day_minutes = 24 * 60;

/// What is left of a text to be read, without the blanks before it.
struct Rest {
  std::string_view text;

  void skip_blanks() {
    while (!text.empty() && (text[0] == ' ' || text[0] == '\t')) text.remove_prefix(1);
  }
  bool take(std::string_view word) {
    skip_blanks();
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
  }
  bool is_empty() {
    skip_blanks();
    return text.empty();
  }
  std::optional<std::size_t> day() {
    skip_blanks();
    for (std::size_t i = 0; i < day_names.size(); ++i)
      if (take(day_names[i])) return i;
    return std::nullopt;
  }
  std::optional<std::int32_t> two_digits() {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (text.size() < 2 || !is_digit(text[0]) || !is_digit(text[1])) return std::nullopt;
    const std::int32_t number = (text[0] - '0') * 10 + (text[1] - '0');
    text.remove_prefix(2);
    return number;
  }
  /// "08:30", in minutes.
  std::optional<std::int32_t> time() {
    skip_blanks();
    const auto hour = two_digits();
    if (!hour || !text.starts_with(':')) return std::nullopt;
    text.remove_prefix(1);
    const auto minute = two_digits();
    if (!minute || *minute > 59 || *hour > 24 || (*hour == 24 && *minute > 0)) return std::nullopt;
    return *hour * 60 + *minute;
  }
};

/// "Mo-Fr,Su": false where what begins as days does not go on so. No day at all means every day.
bool read_days(Rest& rest, std::array<bool, 7>& days) {
  auto first = rest.day();
  if (!first) {
    days.fill(true);
    return true;
  }
  for (;;) {
    std::size_t last = *first;
    if (rest.take("-")) {
      const auto until = rest.day();
      if (!until) return false;
      last = *until;
    }
    for (std::size_t i = *first;; i = (i + 1) % days.size()) {
      days[i] = true;
      if (i == last) break;
    }
    if (!rest.take(",")) return true;
    first = rest.day();
    if (!first) return false;
  }
}

bool read_times(Rest& rest, std::vector<WeeklyHours::Span>& spans) {
  if (rest.take("off") || rest.take("closed")) return true;
  if (rest.take("24/7")) {
    spans.push_back({0, day_minutes});
    return true;
  }
  do {
    const auto begin = rest.time();
    if (!begin || *begin == day_minutes || !rest.take("-")) return false;
    const auto end = rest.time();
    if (!end || *end == *begin) return false;
    spans.push_back({*begin, *end > *begin ? *end : *end + day_minutes});
  } while (rest.take(","));
  return true;
}

}  // namespace

std::expected<WeeklyHours, std::string> parse_weekly_hours(std::string_view text) {
  WeeklyHours hours;
  bool has_rule = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    const std::string_view rule = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    Rest rest{rule};
    if (rest.is_empty()) continue;
    std::array<bool, 7> days{};
    std::vector<WeeklyHours::Span> spans;
    if (!read_days(rest, days) || !read_times(rest, spans) || !rest.is_empty())
      return std::unexpected(fmt::format(
          "'{}' are no hours of a week: \"Mo-Fr 08:30-18:00; Sa,Su 10:00-19:00\"", rule));
    for (std::size_t i = 0; i < days.size(); ++i)
      if (days[i]) hours.day[i] = spans;
    has_rule = true;
  }
  if (!has_rule)
    return std::unexpected(
        std::string("it holds no hours: \"Mo-Fr 08:30-18:00; Sa,Su 10:00-19:00\""));
  return hours;
}

bool holds(const WeeklyHours& hours, int weekday, int minute) noexcept {
  const auto day = static_cast<std::size_t>(((weekday % 7) + 7) % 7);
  const auto within = [](const std::vector<WeeklyHours::Span>& spans, std::int32_t at) {
    return std::ranges::any_of(
        spans, [at](const WeeklyHours::Span& span) { return span.begin <= at && at < span.end; });
  };
  return within(hours.day[day], minute) || within(hours.day[(day + 6) % 7], minute + day_minutes);
}

}  // namespace docent::config
