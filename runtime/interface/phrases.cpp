#include "runtime/interface/phrases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/interface/control.h"
#include "runtime/interface/plural.h"

namespace docent::interface {
namespace {

bool is_first_byte(char c) noexcept {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

/// The pieces of a UTF-8 text, one a character.
std::string_view character(std::string_view text, std::size_t index) noexcept {
  std::size_t begin = 0, seen = 0;
  for (; begin < text.size(); ++begin)
    if (is_first_byte(text[begin]) && seen++ == index) break;
  std::size_t end = std::min(begin + 1, text.size());
  while (end < text.size() && !is_first_byte(text[end])) ++end;
  return text.substr(begin, end - begin);
}

/// Quotation marks and brackets that close belong to the sentence before them.
constexpr std::array<std::string_view, 9> closing{"\"", "'", ")", "”", "’", "»", "」", "』", "）"};

std::string_view without_closing(std::string_view text) noexcept {
  for (auto mark = closing.begin(); mark != closing.end();) {
    const bool closes = text.ends_with(*mark);
    if (closes) text.remove_suffix(mark->size());
    mark = closes ? closing.begin() : mark + 1;
  }
  return text;
}

/// Does a sentence end before this byte of a line? Where languages have blanks, one follows.
bool ends_sentence(std::string_view line, std::size_t end) noexcept {
  constexpr std::array<std::string_view, 8> before_blank{".", "!", "?", "…", "؟", "۔", "।", "॥"};
  constexpr std::array<std::string_view, 4> anywhere{"。", "！", "？", "．"};
  const std::string_view rest = line.substr(end);
  const auto begins_rest = [&](std::string_view mark) { return rest.starts_with(mark); };
  if (std::ranges::any_of(closing, begins_rest)) return false;
  const std::string_view said = without_closing(line.substr(0, end));
  const auto ends_it = [&](std::string_view mark) { return said.ends_with(mark); };
  return std::ranges::any_of(anywhere, ends_it) ||
         (rest.starts_with(' ') && std::ranges::any_of(before_blank, ends_it));
}

namespace chr = std::chrono;

/// A time of day, by the clock of a language.
std::string clock_in(const Museum& museum, std::uint32_t language, chr::minutes since_midnight) {
  constexpr chr::hours noon{12};
  if (since_midnight == noon) return std::string(word(museum, language, "noon"));
  const auto number = [&](long n) { return number_in(museum, language, n); };
  const long hour = chr::floor<chr::hours>(since_midnight).count();
  const long minute = since_midnight.count() % 60;
  std::string text(word(museum, language, minute == 0 ? "clock_hour" : "clock"));
  text = filled_in(text, "hour", number((hour + 11) % 12 + 1));
  text = filled_in(text, "hour_of_day", number(hour));
  text = filled_in(text, "minute", number(minute / 10) + number(minute % 10));
  return filled_in(text, "half",
                   word(museum, language, since_midnight < noon ? "before_noon" : "after_noon"));
}

/// A day of the calendar.
std::string date_in(const Museum& museum, std::uint32_t language, chr::local_days day,
                    std::optional<chr::local_days> today) {
  const chr::year_month_day date(day);
  const bool is_this_year = today && chr::year_month_day(*today).year() == date.year();
  const std::string month = fmt::format("month_{}", static_cast<unsigned>(date.month()));
  std::string text(word(museum, language, is_this_year ? "date" : "date_of_year"));
  text = filled_in(text, "day", number_in(museum, language, static_cast<unsigned>(date.day())));
  text = filled_in(text, "month", word(museum, language, month));
  return filled_in(text, "year", number_in(museum, language, static_cast<int>(date.year())));
}

}  // namespace

std::size_t end_of_part(std::string_view line) noexcept {
  if (line.size() <= longest_line) return line.size();
  for (std::size_t end = longest_line; end > longest_line / 2; --end)
    if (ends_sentence(line, end)) return end;
  const std::size_t blank = line.rfind(' ', longest_line);
  if (blank != std::string_view::npos && blank > 0) return blank;
  for (std::size_t end = longest_line; end > longest_line - 4; --end)
    if (is_first_byte(line[end])) return end;
  return longest_line;  // no letters at all
}

std::string filled_in(std::string_view text, std::string_view name, std::string_view value) {
  const std::string hole = fmt::format("{{{}}}", name);
  std::string out(text);
  for (std::size_t at = out.find(hole); at != std::string::npos;
       at = out.find(hole, at + value.size()))
    out.replace(at, hole.size(), value);
  return out;
}

std::string number_in(const Museum& museum, std::uint32_t language, long number) {
  std::string_view digits = word(museum, language, "digits");
  if (digits == "digits") digits = "0123456789";
  std::string out;
  for (const char c : fmt::format("{}", number))
    if (c >= '0' && c <= '9')
      out += character(digits, static_cast<std::size_t>(c - '0'));
    else
      out += c;
  return out;
}

std::string distance_in(const Museum& museum, std::uint32_t language, double metres) {
  const long whole = std::max(1L, std::lround(metres));
  return filled_in(word(museum, language, "distance"), "n", number_in(museum, language, whole));
}

std::string time_in(const Museum& museum, std::uint32_t language, double seconds, Digits digits) {
  if (seconds < 8) return std::string(word(museum, language, "time_moment"));
  if (seconds < 40) return std::string(word(museum, language, "time_half"));
  const long minutes = std::max(1L, std::lround(seconds / 60));
  const std::string_view key = time_word(language_tag(museum, language), minutes);
  return filled_in(
      word(museum, language, key), "n",
      digits == Digits::Plain ? fmt::format("{}", minutes) : number_in(museum, language, minutes));
}

std::string minutes_in(const Museum& museum, std::uint32_t language, long minutes, Digits digits) {
  const std::string_view form = plural_form(language_tag(museum, language), minutes);
  return filled_in(
      word(museum, language, fmt::format("minutes_{}", form)), "n",
      digits == Digits::Plain ? fmt::format("{}", minutes) : number_in(museum, language, minutes));
}

std::string title_in(const Museum& museum, std::uint32_t language, const Tour& tour,
                     Digits digits) {
  if (is_for_time(tour)) return minutes_in(museum, language, std::lround(tour.minutes), digits);
  return std::string(in_language(museum, language, tour.title));
}

std::string_view time_word(std::string_view tag, long minutes) noexcept {
  if (minutes <= 2) return minutes <= 1 ? "time_one" : "time_two";
  const std::string_view form = plural_form(tag, minutes);
  if (form == "one") return "time_21";
  return form == "two" || form == "few" ? "time_few" : "time_many";
}

std::string moment_in(const Museum& museum, std::uint32_t language, LocalMinute moment,
                      std::optional<chr::local_days> today) {
  constexpr chr::days one{1}, week{7};
  const auto day = chr::floor<chr::days>(moment);
  const chr::minutes since_midnight = moment - day;
  if (!today || day < *today || day >= *today + week) return date_in(museum, language, day, today);
  if (day == *today) return clock_in(museum, language, since_midnight);
  const std::string name = day == *today + one
                               ? "tomorrow"
                               : fmt::format("weekday_{}", chr::weekday(day).iso_encoding());
  const std::string_view on = word(museum, language, name);
  if (since_midnight == chr::minutes(0)) return std::string(on);
  const std::string text = filled_in(word(museum, language, "day_and_clock"), "day", on);
  return filled_in(text, "clock", clock_in(museum, language, since_midnight));
}

}  // namespace docent::interface
