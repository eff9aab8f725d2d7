#include "runtime/kiosk/counts_folder.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <map>
#include <string>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace docent::kiosk::counts_folder_test {
namespace {

using Kind = CountedCell::Kind;
using testing::HasSubstr;

DailyCounts so_many(std::uint64_t visits) {
  DailyCounts counts{.day = {}, .touches = 10 * visits, .visits = {}};
  if (visits > 0) counts.visits[{Kind::Language, "en"}] = visits;
  return counts;
}

unsigned mode_of(const std::filesystem::path& file) {
  struct stat status{};
  return stat(file.c_str(), &status) == 0 ? status.st_mode & 0777U : 0;
}

TEST(CountsFolder, PublishesADayOnlyWhenItIsOver) {
  const test::TemporaryFolder folder;
  CountsFolder counts(folder.path());

  ASSERT_TRUE(counts.take("2026-11-23", so_many(7)));
  EXPECT_EQ(published_csv(folder.path()).value(), "day,kind,name,count\n");
  EXPECT_EQ(counts.last_day(), std::nullopt);

  ASSERT_TRUE(counts.take("2026-11-24", so_many(2)));
  EXPECT_EQ(published_csv(folder.path()).value(),
            "day,kind,name,count\n2026-11-23,visits,,7\n2026-11-23,touches,,70\n"
            "2026-11-23,language,en,7\n");
  EXPECT_EQ(counts.open_day().touches, 20U);
  EXPECT_EQ(counts.last_day()->visits, 7U);
}

TEST(CountsFolder, KeepsTheOpenDayForItsOwnUserAndTheOthersForAll) {
  const mode_t before = umask(0077);  // as the unit sets it
  const test::TemporaryFolder folder;
  CountsFolder counts(folder.path());
  ASSERT_TRUE(counts.take("2026-11-23", so_many(7)));
  ASSERT_TRUE(counts.take("2026-11-24", so_many(1)));
  umask(before);

  EXPECT_EQ(mode_of(folder.path() / "open"), 0600U);
  EXPECT_EQ(mode_of(folder.path() / "2026-11-23.csv"), 0644U);
}

TEST(CountsFolder, GoesOnWithTheDayAfterARestart) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(CountsFolder(folder.path()).take("2026-11-23", so_many(3)));
  ASSERT_TRUE(CountsFolder(folder.path()).take("2026-11-23", so_many(4)));
  CountsFolder counts(folder.path());
  ASSERT_TRUE(counts.take("2026-11-25", so_many(0)));

  EXPECT_EQ(counts.last_day()->visits, 7U);
  EXPECT_EQ(counts.last_day()->day, "2026-11-23");
  EXPECT_EQ(CountsFolder(folder.path()).last_day(), counts.last_day());
}

TEST(CountsFolder, NeverPublishesADayTwiceWhateverTheClockDoes) {
  EXPECT_TRUE(rc::check("a published file keeps its bytes", [] {
    const test::TemporaryFolder folder;
    std::map<std::string, std::string> told;
    auto counts = std::make_unique<CountsFolder>(folder.path());
    const auto steps = *rc::gen::inRange(1, 40);
    for (int i = 0; i < steps; ++i) {
      if (*rc::gen::inRange(0, 4) == 0) counts = std::make_unique<CountsFolder>(folder.path());
      const std::string day = fmt::format("2026-11-{:02}", *rc::gen::inRange(10, 16));
      RC_ASSERT(counts->take(day, so_many(*rc::gen::inRange<std::uint64_t>(0, 9))).has_value());
      for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        if (entry.path().extension() != ".csv") continue;
        const std::string text = test::text_of(entry.path().string());
        RC_ASSERT(told.emplace(entry.path().filename(), text).first->second == text);
      }
    }
  }));
}

TEST(CountsFolder, ForgetsWhatIsOlderThanItsYear) {
  const test::TemporaryFolder folder;
  for (const char* day : {"2025-10-19", "2025-10-20", "2026-11-22"})
    std::ofstream(folder.path() / (std::string(day) + ".csv")) << counts_header;
  std::ofstream(folder.path() / "notes.csv") << "of staff";
  CountsFolder counts(folder.path());
  ASSERT_TRUE(counts.take("2026-11-23", {}));
  ASSERT_TRUE(counts.take("2026-11-24", {}));

  EXPECT_FALSE(std::filesystem::exists(folder.path() / "2025-10-19.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "2025-10-20.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "notes.csv"));
}

TEST(CountsFolder, KeepsCountingWhereNothingCanBeWritten) {
  const test::TemporaryFolder folder;
  const auto missing = folder.path() / "not-yet";
  CountsFolder counts(missing);

  const Result<void> failed = counts.take("2026-11-23", so_many(6));
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().what, HasSubstr("not-yet/open"));
  EXPECT_FALSE(counts.take("2026-11-24", so_many(1)));
  std::filesystem::create_directory(missing);
  ASSERT_TRUE(counts.take("2026-11-24", so_many(1)));

  // The day could not be closed meanwhile: what came after midnight belongs to it too.
  EXPECT_EQ(counts.last_day()->visits, 7U);
}

TEST(CountsFolder, IsToldAsCsvByTheProgram) {
  const test::TemporaryFolder folder;
  CountsFolder counts(folder.path());
  ASSERT_TRUE(counts.take("2026-11-23", so_many(7)));
  ASSERT_TRUE(counts.take("2026-11-24", {}));

  const test::ProgramRun told =
      test::run_program("docent", "counts '" + folder.path().string() + "'");
  EXPECT_EQ(told.exit_code, 0);
  EXPECT_EQ(told.out, published_csv(folder.path()).value());

  const test::ProgramRun nowhere = test::run_program("docent", "counts /not/there");
  EXPECT_EQ(nowhere.exit_code, 3);
  EXPECT_THAT(nowhere.err, HasSubstr("/not/there: there is no such folder"));
}

}  // namespace
}  // namespace docent::kiosk::counts_folder_test
