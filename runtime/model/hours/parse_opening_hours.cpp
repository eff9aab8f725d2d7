#include <algorithm>
#include <tuple>
#include <utility>

#include "runtime/model/hours/opening_hours.h"

namespace docent {
namespace {

namespace chr = std::chrono;
using Date = DateRange::Date;
using Rule = OpeningHours::Rule;

constexpr std::array<std::string_view, 7> weekday_names{"Mo", "Tu", "We", "Th", "Fr", "Sa", "Su"};
constexpr std::array<std::string_view, 12> month_names{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                       "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};

constexpr std::string_view times_hint = "hours are written \"Mo-Fr 10:00-18:00; Dec 24 off\"";
constexpr std::string_view weekdays_hint = "weekdays are Mo, Tu, We, Th, Fr, Sa, Su";
constexpr std::string_view dates_hint =
    "dates are written \"Dec 24\", \"Dec 24-Jan 06\", \"Apr-Oct\" or \"2026 Dec 24\"";

bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string quoted(std::string_view word) {
  std::string text = "'";
  text.append(word).push_back('\'');
  return text;
}

/// Reads from left to right. Once something was wrong, nothing more is read.
class HoursParser {
 public:
  explicit HoursParser(std::string_view text) : text_(text) {}

  std::expected<OpeningHours, HoursError> hours() {
    OpeningHours read;
    while (is_sound() && !at_end()) {
      if (take(";")) continue;
      read.rules.push_back(rule());
      if (is_sound() && !at_end() && peek() != ';') complain_of_rest();
    }
    if (read.rules.empty() && is_sound()) complain("there are no hours here", times_hint);
    if (!is_sound()) return std::unexpected(std::move(*error_));
    return read;
  }

  std::expected<std::vector<DateRange>, HoursError> dates_alone() {
    std::vector<DateRange> read = dates();
    if (is_sound() && (read.empty() || !at_end())) complain("this is no date", dates_hint);
    if (!is_sound()) return std::unexpected(std::move(*error_));
    return read;
  }

 private:
  bool is_sound() const noexcept { return !error_; }

  void complain_at(std::size_t byte, std::string what, std::string_view hint) {
    if (error_) return;
    const auto is_start = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80; };
    const auto characters = std::ranges::count_if(text_.substr(0, byte), is_start);
    error_ =
        HoursError{static_cast<std::size_t>(characters) + 1, std::move(what), std::string(hint)};
  }
  void complain(std::string what, std::string_view hint) {
    skip_blanks();
    complain_at(at_, std::move(what), hint);
  }

  void complain_of_rest() {
    if (peek() == ',') return complain("a comma begins no further rule", "write ';' between rules");
    if (peek() == '|') return complain("rules with '||' are not known here", "write one rule");
    if (peek() == '"') return complain("comments are not known here", "leave the comment out");
    if (rest().starts_with("\xE2\x80\x93") || rest().starts_with("\xE2\x80\x94"))
      return complain("this is a dash", "write a plain hyphen: 10:00-18:00");
    for (const std::string_view word : {"sunrise", "sunset", "dawn", "dusk"})
      if (rest().starts_with(word))
        return complain("times of the sun are not known here", "write a time: 18:00");
    for (const std::string_view word : {"SH", "week", "easter", "unknown"})
      if (rest().starts_with(word))
        return complain(quoted(word) + " is not known here", "museum.toml(5) lists what is");
    complain("this cannot be read", times_hint);
  }

  // Letters and blanks.
  char look(std::size_t ahead = 0) const noexcept {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  void skip_blanks() noexcept {
    while (look() == ' ' || look() == '\t') ++at_;
  }
  std::string_view rest() noexcept {
    skip_blanks();
    return text_.substr(at_);
  }
  char peek() noexcept {
    skip_blanks();
    return look();
  }
  bool at_end() noexcept {
    skip_blanks();
    return at_ >= text_.size();
  }
  bool take(std::string_view sign) noexcept {
    if (!rest().starts_with(sign)) return false;
    at_ += sign.size();
    return true;
  }
  /// One of several words, none of which goes on with a letter.
  template <std::size_t n>
  std::optional<std::size_t> take_word(const std::array<std::string_view, n>& words) noexcept {
    const std::string_view left = rest();
    for (std::size_t i = 0; i < n; ++i) {
      if (!left.starts_with(words[i])) continue;
      if (left.size() > words[i].size() && is_letter(left[words[i].size()])) continue;
      at_ += words[i].size();
      return i;
    }
    return std::nullopt;
  }
  std::size_t digits() noexcept {
    skip_blanks();
    std::size_t count = 0;
    while (is_digit(look(count))) ++count;
    return count;
  }
  int number(std::size_t count) noexcept {
    int value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value * 10 + (text_[at_ + i] - '0');
    at_ += count;
    return value;
  }

  // Dates.
  bool at_year() noexcept { return digits() == 4 && look(4) != ':'; }
  bool at_day() noexcept {
    const std::size_t count = digits();
    return (count == 1 || count == 2) && look(count) != ':';
  }
  bool at_month() noexcept {
    const std::size_t before = at_;
    const bool is_month = take_word(month_names).has_value();
    at_ = before;
    return is_month;
  }

  void read_day(Date& date) {
    const std::size_t begin = at_;
    date.day = static_cast<unsigned>(number(digits()));
    const int year = date.year == 0 ? 2024 : date.year;  // any leap year
    const chr::year_month_day day{chr::year(year), chr::month(date.month), chr::day(date.day)};
    if (!day.ok()) complain_at(begin, "the month has no such day", dates_hint);
  }
  /// What is not said is as in `before`: "Dec 24,26" and "Dec 24-26".
  Date date(const Date& before) {
    Date read;
    if (at_year()) {
      const std::size_t begin = at_;
      read.year = number(4);
      if (read.year < 1900) complain_at(begin, "a year is from 1900 to 9999", dates_hint);
    }
    if (const auto month = take_word(month_names)) {
      read.month = static_cast<unsigned>(*month) + 1;
      if (at_day()) read_day(read);
    } else if (read.year == 0 && at_day() && before.month != 0) {
      read = before;
      read_day(read);
    } else if (read.year == 0) {
      complain("this is no date", dates_hint);
    }
    return read;
  }

  /// The end of a range may leave out the year that its beginning has.
  void end_range(DateRange& range, std::size_t begin) {
    Date& to = range.to;
    const Date& from = range.from;
    if (from.year != 0 && to.year == 0) {
      const bool is_next_year =
          to.month < from.month || (to.month == from.month && to.day != 0 && to.day < from.day);
      to.year = from.year + (is_next_year ? 1 : 0);
    }
    const auto first = std::tuple(from.year, from.month, from.day);
    const auto last =
        std::tuple(to.year, to.month == 0 ? 12U : to.month, to.day == 0 ? 31U : to.day);
    if (from.year == 0 && to.year != 0)
      complain_at(begin, "the end has a year and the beginning has none", dates_hint);
    else if (from.year != 0 && first > last)
      complain_at(begin, "these dates end before they begin", dates_hint);
  }

  DateRange range(const Date& before) {
    const std::size_t begin = at_;
    DateRange read;
    read.from = read.to = date(before);
    if (take("+")) {
      read.has_end = false;
      if (read.from.year == 0)
        complain_at(begin, "what begins on a date for good needs its year", "\"2026 Dec 24+\"");
    } else if (take("-")) {
      read.to = date(read.from);
      if (is_sound()) end_range(read, begin);
    }
    return read;
  }

  std::vector<DateRange> dates() {
    std::vector<DateRange> read;
    if (!at_year() && !at_month()) return read;
    read.push_back(range({}));
    while (is_sound() && take(",")) {
      skip_blanks();
      read.push_back(range(read.back().to));
    }
    return read;
  }

  // Weekdays.
  std::uint16_t place_in_month() {
    const std::size_t begin = at_;
    const bool from_the_end = take("-");
    if (digits() != 1) {
      complain("this is no number of a weekday in its month", "\"Su[1]\" or \"Su[-1]\"");
      return 0;
    }
    const int which = number(1);
    if (which < 1 || which > 5)
      complain_at(begin, "a month has five of a weekday at most", "\"Su[1]\" or \"Su[-1]\"");
    if (!is_sound()) return 0;
    return static_cast<std::uint16_t>(1U << (from_the_end ? which + 4 : which - 1));
  }
  std::uint16_t places_in_month() {
    if (look() != '[') return Rule::every;
    ++at_;
    std::uint16_t places = 0;
    do places |= place_in_month();
    while (is_sound() && take(","));
    if (is_sound() && !take("]")) complain("a ']' is missing", "\"Su[1]\" or \"Su[-1]\"");
    return places;
  }
  void weekday_range(std::size_t first, Rule& rule) {
    std::size_t last = first;
    std::uint16_t places = places_in_month();
    if (take("-")) {
      const auto until = take_word(weekday_names);
      if (!until) return complain("this is no weekday", weekdays_hint);
      last = *until;
      places = Rule::every;
    }
    for (std::size_t i = first;; i = (i + 1) % 7) {
      rule.weekdays[i] |= places;
      if (i == last) return;
    }
  }
  /// False where there are none: then it is every day.
  bool weekdays(Rule& rule) {
    bool has_any = false;
    do {
      if (const auto day = take_word(weekday_names)) {
        weekday_range(*day, rule);
      } else if (take_word(std::array<std::string_view, 1>{"PH"})) {
        rule.holidays = true;
      } else if (has_any) {
        complain("this is no weekday", weekdays_hint);
      } else {
        return false;
      }
      has_any = true;
    } while (is_sound() && take(","));
    return true;
  }

  // Times.
  std::int32_t time(std::int32_t latest) {
    skip_blanks();
    const std::size_t begin = at_;
    const std::size_t count = digits();
    if (count != 2 || look(2) != ':' || !is_digit(look(3)) || !is_digit(look(4)) ||
        is_digit(look(5))) {
      complain_at(begin, "this is no time of day", "times are written 09:30");
      return 0;
    }
    const int hour = number(2);
    ++at_;
    const int minute = number(2);
    if (minute > 59 || hour * 60 + minute > latest)
      complain_at(begin, "there is no such time of day", "times are written 09:30");
    return hour * 60 + minute;
  }
  std::vector<OpeningHours::Span> times() {
    std::vector<OpeningHours::Span> read;
    do {
      skip_blanks();
      const std::size_t begin_at = at_;
      const std::int32_t begin = time(OpeningHours::day_minutes - 1);
      if (is_sound() && !take("-")) {
        if (peek() == '+')
          complain("when it ends is not said", "write an end: 18:00-22:00");
        else if (!rest().starts_with("\xE2\x80\x93"))
          complain("a time has an end", times_hint);
        else
          complain_of_rest();
      }
      if (!is_sound()) break;
      std::int32_t end = time(2 * OpeningHours::day_minutes);
      if (end == begin) complain_at(begin_at, "this begins and ends at once", times_hint);
      if (end < begin) end += OpeningHours::day_minutes;
      if (end > begin + OpeningHours::day_minutes)
        complain_at(begin_at, "this is longer than a day", times_hint);
      read.push_back({begin, end});
    } while (is_sound() && take(","));
    return read;
  }

  Rule rule() {
    Rule read;
    const bool always = take("24/7");
    bool has_days = false;
    if (!always) {
      read.dates = dates();
      if (!read.dates.empty()) take(":");
      if (is_sound()) has_days = weekdays(read);
      if (is_sound() && is_digit(peek())) read.spans = times();
    }
    if (!has_days) read.weekdays.fill(Rule::every);
    if (!is_sound()) return read;
    const auto state = take_word(std::array<std::string_view, 3>{"open", "off", "closed"});
    read.is_off = state && *state > 0;
    if (always || state || !read.spans.empty()) return read;
    if (at_end() || peek() == ';')
      complain("here a time is missing, or 'off'", times_hint);
    else if (is_letter(peek()) && !has_days && !is_known_otherwise())
      complain("this is no weekday and no month", weekdays_hint);
    else
      complain_of_rest();
    return read;
  }
  /// Does it begin with a word about which there is more to say?
  bool is_known_otherwise() noexcept {
    const std::string_view left = rest();
    return std::ranges::any_of(std::array<std::string_view, 8>{"sunrise", "sunset", "dawn", "dusk",
                                                               "SH", "week", "easter", "unknown"},
                               [&](std::string_view word) { return left.starts_with(word); });
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::optional<HoursError> error_;
};

}  // namespace

std::expected<OpeningHours, HoursError> parse_opening_hours(std::string_view text) {
  return HoursParser(text).hours();
}

std::expected<std::vector<DateRange>, HoursError> parse_dates(std::string_view text) {
  return HoursParser(text).dates_alone();
}

}  // namespace docent
