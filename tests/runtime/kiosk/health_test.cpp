#include "runtime/kiosk/health.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace docent::kiosk::health_test {
namespace {

using Kind = CountedCell::Kind;
using testing::HasSubstr;
using testing::Not;

Health some_health() {
  KioskStatus status;
  status.started = 1763900000.5;
  status.content.museum = "The \"Two\" Rooms\\";
  status.content.written = 1763800000;
  status.counts = {.frames = 1000000, .dropped_frames = 7, .last_frame = 1763910000.25};
  status.refusals = {.count = 1, .last = Errc::Damaged};
  status.free_bytes = 5e9;
  return {.status = status, .is_up = true, .starts = 3, .temperature = 61.5};
}

PublishedCounts some_day() {
  PublishedCounts day{.day = "2026-11-22", .visits = 40, .touches = 900, .cells = {}};
  day.cells[{Kind::Exhibit, "jar"}] = 12;
  day.cells[{Kind::Language, "en"}] = 40;
  return day;
}

TEST(Health, IsToldInMetricsWithTheirUnits) {
  const std::string page = to_prometheus(some_health(), some_day());

  for (const char* line :
       {"docent_up 1\n", "docent_starts_total 3\n", "docent_frames_total 1000000\n",
        "docent_dropped_frames_total 7\n", "docent_last_frame_time_seconds 1763910000.25\n",
        "docent_content_info{museum=\"The \\\"Two\\\" Rooms\\\\\"} 1\n",
        "docent_content_time_seconds 1763800000\n", "docent_refused_databases_total 1\n",
        "docent_last_error_info{class=\"damaged\"} 1\n", "docent_content_free_bytes 5000000000\n",
        "docent_temperature_celsius 61.5\n", "docent_day_info{day=\"2026-11-22\"} 1\n",
        "docent_day_visits 40\n", "docent_day_touches 900\n",
        "docent_day_exhibit_visits{exhibit=\"jar\"} 12\n",
        "docent_day_language_visits{language=\"en\"} 40\n"})
    EXPECT_THAT(page, HasSubstr(line));
}

TEST(Health, LeavesOutWhatIsNotKnown) {
  Health health = some_health();
  health.status.refusals.last.reset();
  health.status.free_bytes.reset();
  health.temperature.reset();

  const std::string page = to_prometheus(health, std::nullopt);

  for (const char* name : {"last_error", "free_bytes", "temperature", "docent_day"})
    EXPECT_THAT(page, Not(HasSubstr(name)));
}

TEST(Health, RemembersHowOftenTheKioskWasStarted) {
  EXPECT_EQ(starts_told_in(to_prometheus(some_health(), std::nullopt)), 3U);
  EXPECT_EQ(starts_told_in(""), 0U);
  EXPECT_EQ(starts_told_in("docent_starts_total"), 0U);
  EXPECT_EQ(starts_told_in("docent_starts_total many\n"), 0U);
}

TEST(Health, TakesTheHottestSensor) {
  const test::TemporaryFolder folder;
  for (const auto& [zone, temperature] : {std::pair{"thermal_zone0", "41000\n"},
                                          {"thermal_zone1", "63500\n"},
                                          {"cooling", "99000"}}) {
    std::filesystem::create_directory(folder.path() / zone);
    std::ofstream(folder.path() / zone / "temp") << temperature;
  }
  std::filesystem::create_directory(folder.path() / "thermal_zone2");

  EXPECT_EQ(hottest_sensor(folder.path()), 63.5);
  EXPECT_EQ(hottest_sensor(folder.path() / "nowhere"), std::nullopt);
}

/// Debian's package prometheus has it; the kiosk and its build do not need it.
bool has_promtool() {
  return std::system("command -v promtool >/dev/null") == 0;
}

TEST(Health, IsReadByPrometheusWithoutComplaint) {
  if (!has_promtool()) GTEST_SKIP() << "promtool is not installed (Debian's package prometheus)";
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "docent.prom") << to_prometheus(some_health(), some_day());

  const std::string said = (folder.path() / "said").string();
  const std::string command = "promtool check metrics <'" +
                              (folder.path() / "docent.prom").string() + "' >'" + said + "' 2>&1";

  EXPECT_EQ(std::system(command.c_str()), 0) << test::text_of(said);
}

}  // namespace
}  // namespace docent::kiosk::health_test
