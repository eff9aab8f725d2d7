#include "runtime/model/hours/opening_hours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fmt/format.h>

#include <string>
#include <vector>

namespace docent::opening_hours_test {
namespace {

using namespace std::chrono_literals;
namespace chr = std::chrono;
using testing::HasSubstr;

LocalMinute at(int year, unsigned month, unsigned day, int hour, int minute = 0) {
  const chr::year_month_day date{chr::year(year), chr::month(month), chr::day(day)};
  return chr::local_days(date) + chr::hours(hour) + chr::minutes(minute);
}

std::vector<DateRange> dates(std::string_view text) {
  return parse_dates(text).value_or(std::vector<DateRange>{});
}

/// Are hours that can be read open then? The week of the tests begins on Monday, 9 November 2026.
bool open(std::string_view text, LocalMinute when, std::string_view holidays = "Dec 25") {
  const auto hours = parse_opening_hours(text);
  EXPECT_TRUE(hours.has_value()) << text << ": " << (hours ? "" : hours.error().what);
  return hours && is_open(*hours, dates(holidays), when);
}

TEST(OpeningHours, HoldOnTheirDaysFromTheFirstMinuteToTheLast) {
  constexpr std::string_view hours = "Mo-Fr 08:30-18:00; Sa,Su 10:00-19:00";

  EXPECT_FALSE(open(hours, at(2026, 11, 9, 8, 29)));
  EXPECT_TRUE(open(hours, at(2026, 11, 9, 8, 30)));
  EXPECT_TRUE(open(hours, at(2026, 11, 13, 17, 59)));
  EXPECT_FALSE(open(hours, at(2026, 11, 13, 18)));
  EXPECT_TRUE(open(hours, at(2026, 11, 15, 18)));
}

TEST(OpeningHours, BelongPastMidnightToTheDayOnWhichTheyBegin) {
  EXPECT_TRUE(open("Fr 20:00-02:00", at(2026, 11, 14, 1, 59)));
  EXPECT_FALSE(open("Fr 20:00-02:00", at(2026, 11, 14, 2)));
  EXPECT_FALSE(open("Fr 20:00-02:00", at(2026, 11, 13, 1)));
  EXPECT_TRUE(open("Fr 20:00-26:00", at(2026, 11, 14, 1, 59)));
  EXPECT_TRUE(open("Fr 20:00-02:00; Sa off", at(2026, 11, 14, 1)));
}

TEST(OpeningHours, AreReplacedByALaterRuleOnItsDays) {
  EXPECT_FALSE(open("10:00-18:00; Mo off", at(2026, 11, 9, 12)));
  EXPECT_TRUE(open("10:00-18:00; Th 10:00-21:00", at(2026, 11, 12, 20)));
  EXPECT_FALSE(open("10:00-18:00; Dec 24 10:00-14:00", at(2026, 12, 24, 15)));
}

TEST(OpeningHours, LoseOnlyGivenTimesToARuleThatIsOffThen) {
  constexpr std::string_view hours = "Mo-Sa 10:00-18:00; 12:00-13:00 off";

  EXPECT_TRUE(open(hours, at(2026, 11, 9, 11, 59)));
  EXPECT_FALSE(open(hours, at(2026, 11, 9, 12)));
  EXPECT_TRUE(open(hours, at(2026, 11, 9, 13)));
}

TEST(OpeningHours, KnowDatesOfOneYearOfEveryYearAndRoundItsEnd) {
  EXPECT_FALSE(open("24/7; Dec 24-Jan 06 off", at(2027, 1, 6, 23, 59)));
  EXPECT_TRUE(open("24/7; Dec 24-Jan 06 off", at(2027, 1, 7, 0)));
  EXPECT_FALSE(open("24/7; 2026 Dec 24-26 off", at(2026, 12, 26, 9)));
  EXPECT_TRUE(open("24/7; 2026 Dec 24-26 off", at(2027, 12, 26, 9)));
  EXPECT_FALSE(open("24/7; 2026 Dec 24-Jan 06 off", at(2027, 1, 3, 9)));
  EXPECT_TRUE(open("Apr-Oct 09:00-17:00", at(2026, 10, 31, 16)));
  EXPECT_FALSE(open("Apr-Oct 09:00-17:00", at(2026, 11, 1, 16)));
  EXPECT_FALSE(open("24/7; Dec 25,26 off", at(2026, 12, 26, 9)));
  EXPECT_FALSE(open("24/7; 2026 Dec 24+ off", at(2031, 3, 1, 9)));
  EXPECT_TRUE(open("2026-2027 open", at(2027, 12, 31, 23)));
  EXPECT_FALSE(open("2026-2027 open", at(2028, 1, 1, 0)));
  EXPECT_TRUE(open("Apr-Oct: Mo-Fr 09:00-17:00", at(2026, 10, 30, 16)));
}

TEST(OpeningHours, KnowPublicHolidaysAndTheFirstAndLastSundays) {
  EXPECT_FALSE(open("10:00-18:00; PH off", at(2026, 12, 25, 12)));
  EXPECT_TRUE(open("Su,PH 10:00-18:00", at(2026, 12, 25, 12)));
  EXPECT_FALSE(open("Su,PH 10:00-18:00", at(2026, 12, 24, 12)));
  EXPECT_TRUE(open("Su[1] 10:00-18:00", at(2026, 11, 1, 12)));
  EXPECT_FALSE(open("Su[1] 10:00-18:00", at(2026, 11, 8, 12)));
  EXPECT_TRUE(open("Su[2,-1] 10:00-18:00", at(2026, 11, 29, 12)));
}

TEST(OpeningHours, SayWhereAndWhyTheyCannotBeRead) {
  struct Mistake {
    std::string_view text, what;
    std::size_t column;
  };
  for (const auto& [text, what, column] :
       std::vector<Mistake>{{"", "no hours", 1},
                            {"mornings", "no weekday and no month", 1},
                            {"Mon-Fri 10:00-18:00", "no weekday and no month", 1},
                            {"Mo-Fri 10:00-18:00", "no weekday", 4},
                            {"Mo 9:00-18:00", "no time of day", 4},
                            {"Mo 09:00", "a time has an end", 9},
                            {"Mo 18:00+", "when it ends", 9},
                            {"Mo 09:00-09:00", "at once", 4},
                            {"Mo 25:00-26:00", "no such time", 4},
                            {"Mo 09:00\xE2\x80\x93"
                             "18:00",
                             "this is a dash", 9},
                            {"Mo", "a time is missing", 3},
                            {"Mo-Fr 09:00-18:00, Sa 10:00-12:00", "no time of day", 20},
                            {"Mo-Fr 09:00-18:00 || open", "'||'", 19},
                            {"sunrise-sunset", "times of the sun", 1},
                            {"SH off", "'SH' is not known", 1},
                            {"Feb 30 off", "no such day", 5},
                            {"2026 Dec 24-2025 Jan 01 off", "end before they begin", 1},
                            {"Dec 24+ off", "needs its year", 1},
                            {"Su[6] off", "five of a weekday", 4},
                            {"Su[1 off", "']' is missing", 6}}) {
    const auto hours = parse_opening_hours(text);
    ASSERT_FALSE(hours.has_value()) << text;
    EXPECT_THAT(hours.error().what, HasSubstr(std::string(what))) << text;
    EXPECT_EQ(hours.error().column, column) << text;
    EXPECT_FALSE(hours.error().hint.empty()) << text;
  }
}

TEST(OpeningHours, SayWhenTheyNextBeginOrEnd) {
  const auto hours = parse_opening_hours("Tu-Su 10:00-18:00; Dec 24-26 off").value();

  EXPECT_EQ(next_change(hours, {}, at(2026, 11, 10, 9)), at(2026, 11, 10, 10));
  EXPECT_EQ(next_change(hours, {}, at(2026, 11, 10, 10)), at(2026, 11, 10, 18));
  EXPECT_EQ(next_change(hours, {}, at(2026, 11, 15, 18)), at(2026, 11, 17, 10));
  EXPECT_EQ(next_change(hours, {}, at(2026, 12, 23, 18)), at(2026, 12, 27, 10));
  EXPECT_EQ(next_change(parse_opening_hours("24/7").value(), {}, at(2026, 1, 1, 0)), std::nullopt);
}

// The oracle: rules are painted one after the other onto a calendar of minutes. Each minute holds
// the day on which the hours that it is in began, today or yesterday.

constexpr int calendar_days = 800;
constexpr int day_minutes = 24 * 60;
const chr::local_days first_day = chr::local_days(chr::year(2023) / 12 / 1);

using Calendar = std::vector<std::array<bool, 2>>;  // since today, since yesterday

struct WrittenRule {
  int first_day = 0, last_day = calendar_days - 1;  // of the calendar, where `dated`
  bool dated = false, has_times = true, is_off = false, with_holidays = false;
  std::array<bool, 7> weekdays{};
  std::vector<std::pair<int, int>> spans;
};

chr::year_month_day day_of(int index) {
  return chr::year_month_day(first_day + chr::days(index));
}

constexpr std::array<std::string_view, 12> months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                  "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};

std::string date_text(int index) {
  const chr::year_month_day date = day_of(index);
  return fmt::format("{} {} {:02}", static_cast<int>(date.year()),
                     months[static_cast<unsigned>(date.month()) - 1],
                     static_cast<unsigned>(date.day()));
}

std::string text_of(const WrittenRule& rule) {
  constexpr std::array<std::string_view, 7> names{"Mo", "Tu", "We", "Th", "Fr", "Sa", "Su"};
  std::vector<std::string> days;
  for (std::size_t i = 0; i < 7; ++i)
    if (rule.weekdays[i]) days.emplace_back(names[i]);
  if (rule.with_holidays) days.emplace_back("PH");
  std::vector<std::string> spans;
  for (const auto& [begin, end] : rule.spans)
    spans.push_back(
        fmt::format("{:02}:{:02}-{:02}:{:02}", begin / 60, begin % 60, end / 60, end % 60));
  return fmt::format("{} {} {} {}",
                     rule.dated ? date_text(rule.first_day) + "-" + date_text(rule.last_day) : "",
                     fmt::join(days, ","), fmt::join(spans, ","),
                     rule.is_off ? "off" : (spans.empty() ? "open" : ""));
}

bool is_on(const WrittenRule& rule, int day, const std::vector<bool>& holiday) {
  if (day < 0) return false;
  if (rule.dated && (day < rule.first_day || day > rule.last_day)) return false;
  const std::size_t weekday = chr::weekday(first_day + chr::days(day)).iso_encoding() - 1;
  const bool every_day = rule.weekdays == std::array<bool, 7>{} && !rule.with_holidays;
  return every_day || rule.weekdays[weekday] ||
         (rule.with_holidays && holiday[static_cast<std::size_t>(day)]);
}

void paint_day(Calendar& calendar, int day, int begin, int end, bool value, bool both) {
  for (int minute = begin; minute < end; ++minute) {
    const auto index = static_cast<std::size_t>(day * day_minutes + minute);
    if (index >= calendar.size()) return;
    calendar[index][minute < day_minutes ? 0 : 1] = value;
    if (both) calendar[index] = {value, value};
  }
}

void paint(Calendar& calendar, const WrittenRule& rule, const std::vector<bool>& holiday) {
  for (int day = 0; day < calendar_days; ++day) {
    if (!is_on(rule, day, holiday)) continue;
    if (rule.is_off && !rule.spans.empty()) {
      for (const auto& [begin, end] : rule.spans) paint_day(calendar, day, begin, end, false, true);
      continue;
    }
    paint_day(calendar, day, 0, 2 * day_minutes, false, false);
    if (rule.is_off) continue;
    if (rule.spans.empty()) paint_day(calendar, day, 0, day_minutes, true, false);
    for (const auto& [begin, end] : rule.spans) paint_day(calendar, day, begin, end, true, false);
  }
}

WrittenRule random_rule() {
  WrittenRule rule;
  rule.dated = *rc::gen::inRange(0, 3) == 0;
  rule.first_day = *rc::gen::inRange(0, calendar_days);
  rule.last_day = *rc::gen::inRange(rule.first_day, calendar_days);
  rule.is_off = *rc::gen::inRange(0, 3) == 0;
  rule.with_holidays = *rc::gen::inRange(0, 5) == 0;
  if (*rc::gen::arbitrary<bool>())
    for (bool& day : rule.weekdays) day = *rc::gen::arbitrary<bool>();
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
    const int begin = *rc::gen::inRange(0, day_minutes);
    rule.spans.emplace_back(begin, begin + *rc::gen::inRange(1, day_minutes + 1));
  }
  return rule;
}

RC_GTEST_PROP(OpeningHours, AreOpenInThoseMinutesThatAreLeftWhenAllRulesArePainted, ()) {
  std::vector<bool> holiday(calendar_days);
  std::string holidays = date_text(0);
  holiday[0] = true;
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    const int day = *rc::gen::inRange(0, calendar_days);
    holiday[static_cast<std::size_t>(day)] = true;
    holidays += "," + date_text(day);
  }
  Calendar calendar(static_cast<std::size_t>(calendar_days) * day_minutes);
  std::string text;
  for (int i = *rc::gen::inRange(1, 5); i > 0; --i) {
    const WrittenRule rule = random_rule();
    text += (text.empty() ? "" : ";") + text_of(rule);
    paint(calendar, rule, holiday);
  }

  const auto hours = parse_opening_hours(text);
  const auto days = parse_dates(holidays);

  RC_ASSERT(hours.has_value());
  RC_ASSERT(days.has_value());
  const int begin = *rc::gen::inRange(2, calendar_days - 4) * day_minutes;
  const auto is_painted = [&](int minute) {
    const auto& at = calendar[static_cast<std::size_t>(minute)];
    return at[0] || at[1];
  };
  for (int minute = begin; minute < begin + 3 * day_minutes; ++minute)
    RC_ASSERT(is_open(*hours, *days, first_day + chr::minutes(minute)) == is_painted(minute));
  const auto change = next_change(*hours, *days, first_day + chr::minutes(begin));
  int painted = begin;
  const int last = static_cast<int>(calendar.size());
  while (painted < last && is_painted(painted) == is_painted(begin)) ++painted;
  if (painted < last) RC_ASSERT(change == first_day + chr::minutes(painted));
}

}  // namespace
}  // namespace docent::opening_hours_test
