#include "runtime/kiosk/screen_hours.h"

#include <gtest/gtest.h>

namespace docent::kiosk::screen_hours_test {
namespace {

using namespace std::chrono_literals;

constexpr LocalMinute monday_noon{0, 12 * 60}, monday_night{0, 23 * 60};

std::optional<config::WeeklyHours> daytime() {
  return *config::parse_weekly_hours("08:00-18:00");
}

TEST(ScreenHours, LightTheScreenAlwaysWhereNoneAreSet) {
  const std::optional<config::WeeklyHours> none;
  ScreenHours hours(none, 60s);

  EXPECT_FALSE(hours.are_set());
  EXPECT_TRUE(hours.is_lit(monday_night, 1, false));
}

TEST(ScreenHours, LightTheScreenInTheirTime) {
  const auto week = daytime();
  ScreenHours hours(week, 60s);

  EXPECT_TRUE(hours.is_lit(monday_noon, 1, false));
  EXPECT_FALSE(hours.is_lit(monday_night, 1, false));
}

TEST(ScreenHours, LightTheScreenForWhoeverTouchesIt) {
  const auto week = daytime();
  ScreenHours hours(week, 60s);

  EXPECT_FALSE(hours.is_lit(monday_night, 1, false));
  EXPECT_TRUE(hours.is_lit(monday_night, 0.02, true));
  EXPECT_TRUE(hours.is_lit(monday_night, 50, false));
  EXPECT_TRUE(hours.is_lit(monday_night, 0.02, true)) << "still there";
  EXPECT_TRUE(hours.is_lit(monday_night, 59, false));
  EXPECT_FALSE(hours.is_lit(monday_night, 2, false));
}

TEST(LocalMinute, IsInTheWeek) {
  const LocalMinute now = local_minute();

  EXPECT_TRUE(now.weekday >= 0 && now.weekday < 7);
  EXPECT_TRUE(now.minute >= 0 && now.minute < 24 * 60);
}

}  // namespace
}  // namespace docent::kiosk::screen_hours_test
