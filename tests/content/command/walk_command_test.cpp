#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/run_program.h"
#include "tests/support/sample_database.h"
#include "tests/support/temporary_folder.h"

namespace docent::test::walk_command_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A gentle bend of 6 m, and a place for the walk along it.
class WalkCommand : public testing::Test {
 protected:
  WalkCommand() { std::ofstream(path()) << "x,y\n0,0\n3,0\n4.5,0.3\n6,0.9\n"; }

  ProgramRun walk(const std::string& options) const { return walk_in(sample_database(), options); }
  ProgramRun walk_in(const std::filesystem::path& database, const std::string& options) const {
    return run_program("docent-content", "walk '" + database.string() + "' --path '" +
                                             path().string() + "' -o '" + output().string() + "' " +
                                             options);
  }

  /// A hall whose guide has no clip that turns.
  std::filesystem::path hall_without_turns() const {
    const auto clips = folder_.path() / "clips", hall = folder_.path() / "hall.geojson",
               database = folder_.path() / "hall.db";
    std::filesystem::create_directory(clips);
    for (const char* name : {"clips.toml", "stand-to-walk.bvh", "walk.bvh", "walk-to-stand.bvh"})
      std::filesystem::copy_file(source_dir() / "content/clips" / name, clips / name);
    std::ofstream(hall) << R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,9],[0,0]]]})";
    run_program("docent-content", "compile '" + hall.string() + "' --clips '" + clips.string() +
                                      "' --quiet -o '" + database.string() + "'");
    return database;
  }

  std::filesystem::path path() const { return folder_.path() / "path.csv"; }
  std::filesystem::path output() const { return folder_.path() / "walk.bvh"; }

 private:
  TemporaryFolder folder_;
};

TEST_F(WalkCommand, WalksByThePapersSearchWithTheSameFiguresAsByOurs) {
  const ProgramRun ours = walk("--raw --json");
  const ProgramRun paper = walk("--search paper --lookahead 0.8 --use-rate 0.5 --json");

  ASSERT_EQ(ours.exit_code, 0) << ours.err;
  ASSERT_EQ(paper.exit_code, 0) << paper.err;
  EXPECT_EQ(paper.err, "");
  for (const char* key : {"search_seconds", "total_seconds", "frames", "path_length", "reached",
                          "deviation_mean", "deviation_max", "transitions", "expanded"}) {
    EXPECT_THAT(ours.out, HasSubstr('"' + std::string(key) + "\": "));
    EXPECT_THAT(paper.out, HasSubstr('"' + std::string(key) + "\": "));
  }
  EXPECT_THAT(text_of(output()), StartsWith("HIERARCHY"));
}

TEST_F(WalkCommand, SaysWhereThePapersSearchWasStopped) {
  const ProgramRun run = walk("--search paper --lookahead 6 --time-limit 0.01");

  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("warning[search-stopped]"));
  EXPECT_THAT(run.err, HasSubstr("of 6.15 m"));
}

TEST_F(WalkCommand, GoesToTheEndOfAPathThatTurnsBack) {
  std::ofstream(path()) << "x,y\n0,0\n6,0\n0,0\n";
  const ProgramRun run = walk("--json");

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NEAR(std::stod(run.out.substr(run.out.find("\"reached\": ") + 11)), 12, 0.05);
}

TEST_F(WalkCommand, SaysWhereTheClipsAloneStopShort) {
  std::ofstream(path()) << "x,y\n0,0\n3,0\n3,0.3\n0,0.3\n0,0.6\n3,0.6\n3,0.9\n0,0.9\n";
  const ProgramRun run = walk_in(hall_without_turns(), "--raw");

  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr("error[stops-short]"));
  EXPECT_THAT(run.err, HasSubstr("of the path's 12.90 m"));
  EXPECT_TRUE(std::filesystem::exists(output()));
}

TEST_F(WalkCommand, TellsThatAPathIsLongerThanAnybodyWalks) {
  std::ofstream(path()) << "x,y\n0,0\n1e9,0\n";
  const ProgramRun run = walk("--json");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("long-path"));
  EXPECT_FALSE(std::filesystem::exists(output()));
}

TEST_F(WalkCommand, RefusesOptionsOfTheOtherSearch) {
  for (const char* options :
       {"--search paper --exact", "--lookahead 1", "--use-rate 0.5", "--time-limit 5"}) {
    const ProgramRun run = walk(options);
    EXPECT_EQ(run.exit_code, 2) << options;
    EXPECT_THAT(run.err, HasSubstr("error[walk-options]")) << options;
    EXPECT_FALSE(std::filesystem::exists(output()));
  }
}

}  // namespace
}  // namespace docent::test::walk_command_test
