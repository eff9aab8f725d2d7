#include "runtime/kiosk/reporter.h"

#include <gmock/gmock.h>

#include <fstream>
#include <string>

#include "tests/support/kiosk_run.h"

namespace docent::kiosk::reporter_test {
namespace {

using Kind = CountedCell::Kind;
using testing::HasSubstr;

/// A kiosk whose counts and health are kept in a folder, run for some visits.
class WatchedKiosk {
 public:
  test::ProgramRun run(const std::string& visits, const std::string& more = "") const {
    return test::VisitRun(visits).play("--counts '" + file("") + "' --health '" +
                                           file("docent.prom") + "' --stats '" +
                                           file("stats.json") + "' " + more,
                                       "320x180");
  }
  std::string file(const char* name) const { return (folder_.path() / name).string(); }
  std::optional<DailyCounts> open_day() const {
    return daily_counts_from(test::text_of(file("open")));
  }

 private:
  test::TemporaryFolder folder_;
};

TEST(Reporter, CountsAVisitOnceInEachOfItsCellsWhenItEnds) {
  const WatchedKiosk kiosk;

  // The second visitor is still there at the end, and is not counted.
  const test::ProgramRun ended = kiosk.run(
      "1 tap @exhibit:tripod-ding\n3 tap @route:skeleton\n4 tap @language:zh\n"
      "5 tap @exhibit:painted-jar\n7 tap @exhibit:tripod-ding\n10 tap @home\n"
      "14 tap @exhibit:jade-disc\n18 quit\n");

  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const std::optional<DailyCounts> day = kiosk.open_day();
  ASSERT_TRUE(day.has_value());
  EXPECT_EQ(day->visits, (CellCounts{{{Kind::Exhibit, "tripod-ding"}, 1},
                                     {{Kind::Exhibit, "painted-jar"}, 1},
                                     {{Kind::Route, "shortest"}, 1},
                                     {{Kind::Route, "skeleton"}, 1},
                                     {{Kind::Language, "zh"}, 1}}));
  const std::string stats = test::text_of(kiosk.file("stats.json"));
  EXPECT_EQ(day->touches, test::number_in(stats, "touches"));
  EXPECT_EQ(test::number_in(stats, "allocations_in_frames"), 0);
}

TEST(Reporter, TellsHowTheKioskDoesAndThatItHasEnded) {
  const WatchedKiosk kiosk;

  ASSERT_EQ(kiosk.run("2 quit\n").exit_code, 0);
  const std::string first = test::text_of(kiosk.file("docent.prom"));
  ASSERT_EQ(kiosk.run("2 quit\n").exit_code, 0);
  const std::string second = test::text_of(kiosk.file("docent.prom"));

  EXPECT_THAT(first, HasSubstr("docent_up 0\n"));
  EXPECT_THAT(first, HasSubstr("docent_frames_total 121\n"));
  EXPECT_THAT(first, HasSubstr("docent_starts_total 1\n"));
  EXPECT_THAT(first, HasSubstr("docent_content_info{museum=\"Museum of the Three Rivers\"} 1\n"));
  EXPECT_THAT(second, HasSubstr("docent_starts_total 2\n"));
}

TEST(Reporter, PublishesTheDayBeforeAtTheNextStart) {
  const WatchedKiosk kiosk;
  std::ofstream(kiosk.file("open"))
      << counts_header << "2026-01-05,touches,,80\n2026-01-05,exhibit,tripod-ding,4\n"
      << "2026-01-05,route,shortest,9\n2026-01-05,exhibit,jade-disc,9\n2026-01-05,language,en,11\n";

  ASSERT_EQ(kiosk.run("1 quit\n").exit_code, 0);

  EXPECT_EQ(test::text_of(kiosk.file("2026-01-05.csv")),
            "day,kind,name,count\n2026-01-05,visits,,11\n2026-01-05,touches,,80\n"
            "2026-01-05,exhibit,jade-disc,9\n2026-01-05,route,shortest,9\n"
            "2026-01-05,language,en,11\n");
  EXPECT_EQ(kiosk.open_day()->visits, CellCounts{});
  EXPECT_THAT(test::text_of(kiosk.file("docent.prom")), HasSubstr("docent_day_visits 11\n"));
}

TEST(Reporter, SaysOnceWhatCannotBeWrittenAndTheKioskGoesOn) {
  const WatchedKiosk kiosk;

  const test::ProgramRun ended =
      test::VisitRun("3 quit\n").play("--health /not/there/docent.prom", "320x180");

  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(ended.err.find("/not/there/docent.prom"), ended.err.rfind("/not/there/docent.prom"));
  EXPECT_THAT(ended.err, HasSubstr("cannot be written"));
}

}  // namespace
}  // namespace docent::kiosk::reporter_test
