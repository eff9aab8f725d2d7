#include "runtime/model/hours/time_zone.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <ctime>
#include <string>

namespace docent::time_zone_test {
namespace {

using namespace std::chrono_literals;
namespace chr = std::chrono;

constexpr std::string_view berlin = "CET-1CEST,M3.5.0,M10.5.0/3";

chr::sys_seconds utc(int year, unsigned month, unsigned day, int hour, int minute = 0) {
  return chr::sys_days(chr::year(year) / chr::month(month) / chr::day(day)) + chr::hours(hour) +
         chr::minutes(minute);
}
chr::local_seconds wall(int year, unsigned month, unsigned day, int hour, int minute = 0) {
  return chr::local_seconds(utc(year, month, day, hour, minute).time_since_epoch());
}

TEST(TimeZone, ChangesToDaylightSavingAndBack) {
  const TimeZone zone = parse_time_zone(berlin).value();

  EXPECT_EQ(local_time(zone, utc(2026, 3, 29, 0, 59)), wall(2026, 3, 29, 1, 59));
  EXPECT_EQ(local_time(zone, utc(2026, 3, 29, 1)), wall(2026, 3, 29, 3));
  EXPECT_EQ(local_time(zone, utc(2026, 10, 25, 0, 59)), wall(2026, 10, 25, 2, 59));
  EXPECT_EQ(local_time(zone, utc(2026, 10, 25, 1)), wall(2026, 10, 25, 2));
}

TEST(TimeZone, KnowsTheMomentAtWhichAClockShowsATime) {
  const TimeZone zone = parse_time_zone(berlin).value();

  EXPECT_EQ(system_time(zone, wall(2026, 7, 1, 12)), utc(2026, 7, 1, 10));
  EXPECT_EQ(system_time(zone, wall(2026, 10, 25, 2, 30)), utc(2026, 10, 25, 0, 30)) << "the first";
  EXPECT_EQ(system_time(zone, wall(2026, 3, 29, 2, 30)), utc(2026, 3, 29, 1, 30)) << "left out";
}

TEST(TimeZone, RefusesWhatIsNone) {
  for (const char* text : {"", "Europe/Berlin", "CET", "CET-1CEST", "CET-1CEST,M3.5.0",
                           "CET-1CEST,M13.5.0,M10.5.0", "CET-1CEST,M3.5.0,M10.5.0 ", "<+03-3"})
    EXPECT_FALSE(parse_time_zone(text).has_value()) << text;
}

/// What the C library makes of the same rules.
chr::local_seconds shown_by_the_library(const char* zone, chr::sys_seconds at) {
  setenv("TZ", zone, 1);  // NOLINT: the tests of this program have one thread
  tzset();
  const std::time_t moment = at.time_since_epoch().count();
  std::tm shown{};
  localtime_r(&moment, &shown);
  unsetenv("TZ");  // NOLINT: as above
  return chr::local_seconds(at.time_since_epoch() + chr::seconds(shown.tm_gmtoff));
}

RC_GTEST_PROP(TimeZone, ShowsWhatTheLibraryShows, ()) {
  const char* zone = *rc::gen::element(
      "CET-1CEST,M3.5.0,M10.5.0/3", "EST5EDT,M3.2.0,M11.1.0", "GMT0BST,M3.5.0/1,M10.5.0",
      "IST-1GMT0,M10.5.0,M3.5.0/1", "AEST-10AEDT,M10.1.0,M4.1.0/3", "<+0330>-3:30", "UTC0",
      "<+1030>-10:30<+11>-11,M10.1.0,M4.1.0", "EET-2EEST,M3.4.4/50,M10.4.4/50",
      "<-03>3<-02>,M3.5.0/-1,M10.5.0/0", "XST8XDT,J60,J300/3", "YST-5YDT,60/2,300/26");
  const chr::sys_seconds at = utc(1990, 1, 1, 0) + chr::seconds(*rc::gen::inRange<std::int64_t>(
                                                       0, std::int64_t{60} * 366 * 86400));
  const auto rules = parse_time_zone(zone);

  RC_ASSERT(rules.has_value());
  const chr::local_seconds shown = local_time(*rules, at);
  RC_ASSERT(shown == shown_by_the_library(zone, at));
  const chr::sys_seconds back = system_time(*rules, shown);
  RC_ASSERT(local_time(*rules, back) == shown);
  RC_ASSERT(back <= at);
}

RC_GTEST_PROP(TimeZone, ShowsWhatTheLibraryShowsInTheHoursAboutAChange, ()) {
  const char* zone =
      *rc::gen::element("CET-1CEST,M3.5.0,M10.5.0/3", "EST5EDT,M3.2.0,M11.1.0",
                        "AEST-10AEDT,M10.1.0,M4.1.0/3", "IST-1GMT0,M10.5.0,M3.5.0/1");
  const int year = *rc::gen::inRange(2000, 2090);
  const unsigned month = *rc::gen::element(3U, 4U, 10U, 11U);
  const chr::sys_seconds begin = utc(year, month, 1, 0);
  const auto rules = parse_time_zone(zone);

  RC_ASSERT(rules.has_value());
  for (int half_hour = 0; half_hour < 31 * 48; ++half_hour) {
    const chr::sys_seconds at = begin + chr::minutes(30 * half_hour);
    RC_ASSERT(local_time(*rules, at) == shown_by_the_library(zone, at));
  }
}

}  // namespace
}  // namespace docent::time_zone_test
