// What compile and check say while they work, when they are done, and when they cannot begin.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/museum_folder.h"
#include "tests/support/terminal_run.h"

namespace docent::command::compile_command_test {
namespace {

using test::MuseumFolder;
using test::ProgramRun;
using test::run_program;
using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

TEST(CompileCommand, SaysWhatItWroteHowLargeItIsAndHowLongItTook) {
  const MuseumFolder museum;
  const std::string call = "compile '" + museum.path().string() + "' -o '" +
                           museum.database().string() + "' --no-motion";

  const ProgramRun run = run_program("docent-content", call);

  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::string last = run.err.substr(run.err.rfind('\n', run.err.size() - 2) + 1);
  EXPECT_THAT(last, MatchesRegex("wrote .*museum.db, [0-9.]+ [kM]B, in [0-9.]+ s\n"));
  EXPECT_EQ(run_program("docent-content", call + " --quiet").err, "");
}

TEST(CompileCommand, WithJsonSaysNothingButJson) {
  const MuseumFolder museum;
  museum.replace("ground.geojson", "[10, 8], [0, 8], [0, 0]]",
                 "[10, 8], [10, 8], [0, 8], [0, 0]]");  // mended, with a warning

  const ProgramRun run = museum.compile("--json");

  EXPECT_EQ(run.exit_code, 0);
  std::istringstream lines(run.err);
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(nlohmann::json::accept(line)) << line;
  EXPECT_THAT(run.err, HasSubstr("\"severity\":\"warning\""));
  EXPECT_TRUE(nlohmann::json::accept(run.out)) << run.out;
}

TEST(CompileCommand, TakesItsProgressOffTheTerminalBeforeItSaysWhatIsWrong) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "count = 3", "count = -1");

  const std::string shown = test::shown_on_a_terminal(
      "docent-content", {"check", museum.path().string(), "--no-motion"}, "1");

  EXPECT_THAT(shown, HasSubstr("] plan"));
  EXPECT_THAT(shown, HasSubstr("\r\x1b[K" + museum.path().string() + "/museum.toml:12:9: error["));
}

TEST(CompileCommand, SaysWhichSourcesAreMissingBeforeItComputesAnything) {
  for (const char* call : {"compile /nowhere/a.geojson /nowhere/b.geojson -o /nowhere/out.db",
                           "check /nowhere/a.geojson /nowhere/b.geojson"}) {
    const ProgramRun run = run_program("docent-content", call);

    EXPECT_EQ(run.exit_code, 3);
    EXPECT_THAT(run.err, AllOf(HasSubstr("/nowhere/a.geojson: error[missing-source]"),
                               HasSubstr("/nowhere/b.geojson: error[missing-source]")));
    EXPECT_THAT(run.err, Not(HasSubstr(" s\n"))) << "no stage was begun";
  }
}

TEST(CompileCommand, DoesNotComputeTheMotionOfAMuseumWhosePlanIsMissing) {
  const MuseumFolder museum;
  std::filesystem::remove(museum.path() / "ground.geojson");

  const ProgramRun run = run_program("docent-content", "check '" + museum.path().string() + "'");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, AllOf(HasSubstr("error[missing-file]"), Not(HasSubstr("motion"))));
}

TEST(CheckCommand, SaysThatNothingIsWrong) {
  const MuseumFolder museum;

  const ProgramRun run =
      run_program("docent-content", "check '" + museum.path().string() + "' --no-motion");

  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr(museum.path().string() + ": no errors, 0 warnings, in "));
}

TEST(CheckCommand, DoesNotComputeWhatCannotBeWrong) {
  const MuseumFolder museum;
  const std::string plan = (museum.path() / "ground.geojson").string();

  for (const std::string& source : {museum.path().string(), plan}) {
    const ProgramRun run = run_program("docent-content", fmt::format("check '{}'", source));

    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.err, AllOf(HasSubstr("voronoi"), Not(HasSubstr("motion")),
                               Not(HasSubstr("avatar")), Not(HasSubstr("scenery"))));
  }
}

TEST(CheckCommand, LooksAtRecordingsThatDoNotShipWithDocent) {
  const MuseumFolder museum;
  const test::TemporaryFolder clips;
  std::ofstream(clips.path() / "walk.bvh") << "HIERARCHY\nROOT";

  const ProgramRun run =
      run_program("docent-content",
                  "check '" + museum.path().string() + "' --clips '" + clips.path().string() + "'");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("walk.bvh"));
}

}  // namespace
}  // namespace docent::command::compile_command_test
