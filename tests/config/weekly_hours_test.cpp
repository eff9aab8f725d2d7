#include "config/weekly_hours.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace docent::config::weekly_hours_test {
namespace {

constexpr int monday = 0, wednesday = 2, friday = 4, saturday = 5, sunday = 6;

constexpr int at(int hour, int minute = 0) {
  return hour * 60 + minute;
}

TEST(WeeklyHours, HoldOnTheirDaysFromTheFirstMinuteToTheLast) {
  const auto hours = parse_weekly_hours("Mo-Fr 08:30-18:00; Sa,Su 10:00-19:00");

  ASSERT_TRUE(hours.has_value());
  EXPECT_FALSE(holds(*hours, monday, at(8, 29)));
  EXPECT_TRUE(holds(*hours, monday, at(8, 30)));
  EXPECT_TRUE(holds(*hours, friday, at(17, 59)));
  EXPECT_FALSE(holds(*hours, friday, at(18)));
  EXPECT_FALSE(holds(*hours, sunday, at(9)));
  EXPECT_TRUE(holds(*hours, sunday, at(18)));
}

TEST(WeeklyHours, MayHaveABreakAndADayOff) {
  const auto hours = parse_weekly_hours("08:00-12:00, 13:00-17:00; We off");

  ASSERT_TRUE(hours.has_value());
  EXPECT_TRUE(holds(*hours, monday, at(11)));
  EXPECT_FALSE(holds(*hours, monday, at(12, 30)));
  EXPECT_TRUE(holds(*hours, monday, at(13)));
  EXPECT_FALSE(holds(*hours, wednesday, at(11)));
}

TEST(WeeklyHours, GoOnPastMidnightAndRoundTheWeek) {
  const auto hours = parse_weekly_hours("Fr-Su 20:00-02:00");

  ASSERT_TRUE(hours.has_value());
  EXPECT_TRUE(holds(*hours, saturday, at(1)));
  EXPECT_TRUE(holds(*hours, monday, at(1, 59)));
  EXPECT_FALSE(holds(*hours, monday, at(2)));
  EXPECT_FALSE(holds(*hours, friday, at(1)));
  EXPECT_TRUE(holds(*parse_weekly_hours("Sa-Mo 10:00-11:00"), sunday, at(10)));
}

TEST(WeeklyHours, MayBeAllTheTime) {
  const auto hours = parse_weekly_hours("24/7");

  ASSERT_TRUE(hours.has_value());
  for (int minute = 0; minute < at(24); ++minute) EXPECT_TRUE(holds(*hours, wednesday, minute));
}

TEST(WeeklyHours, SayWhatCannotBeRead) {
  for (const char* text : {"", ";", "mornings", "Mo", "Mo-", "Mo 8:00-18:00", "Mo 08:00", "08:00-",
                           "08:00-08:00", "25:00-26:00", "08:60-09:00", "24:00-25:00",
                           "Mo-Fr 08:00-18:00 PH", "PH off", "Mo,,Tu 08:00-09:00"}) {
    const auto hours = parse_weekly_hours(text);

    ASSERT_FALSE(hours.has_value()) << text;
    EXPECT_NE(hours.error().find("08:30-18:00"), std::string::npos) << text;
  }
}

RC_GTEST_PROP(WeeklyHours, TakeAnyTextWithoutHarm, (const std::string& text)) {
  if (const auto hours = parse_weekly_hours(text))
    for (int day = 0; day < 7; ++day) holds(*hours, day, 700);
}

}  // namespace
}  // namespace docent::config::weekly_hours_test
