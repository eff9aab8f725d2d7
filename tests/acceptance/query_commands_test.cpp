#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/acceptance/run.h"
#include "tests/support/reference_data.h"
#include "tests/support/sample_database.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wide_text.h"

namespace docent::test::query_commands_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A hall of 12 by 8 m with a box of 2 by 2 m in the middle.
class QueryCommands : public testing::Test {
 protected:
  void SetUp() override {
    write_file(folder_.path() / "hall.geojson",
               R"({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon",
                   "coordinates": [[[0,0],[12,0],[12,8],[0,8],[0,0]],
                                   [[5,3],[5,5],[7,5],[7,3],[5,3]]]}})");
    const Outcome compiled =
        ask({"compile", path("hall.geojson"), "-o", path("hall.db"), "--no-motion", "--quiet"});
    ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
  }
  [[nodiscard]] std::string path(const char* name) const {
    return (folder_.path() / name).string();
  }
  static Outcome ask(const std::vector<std::string>& arguments) {
    return run(program("docent-content"), arguments);
  }
  [[nodiscard]] Outcome route(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"route", path("hall.db"), "--kind", "shortest"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return ask(arguments);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(QueryCommands, RouteAnswersInJson) {
  const Outcome outcome = route({"--from", "1,1", "--to", "11,1", "--radius", "0.25", "--json"});

  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out,
            "{\"status\": \"ok\", \"length\": 10, \"clearance_min\": 1, "
            "\"points\": [[1, 1], [11, 1]], \"seconds\": 10, \"floors\": [\"hall\"], "
            "\"legs\": [{\"floor\": \"hall\", \"points\": [[1, 1], [11, 1]]}]}\n");
}

TEST_F(QueryCommands, RouteSaysWhatIsBlocked) {
  EXPECT_THAT(route({"--from", "6,4", "--to", "1,1", "--json"}).out,
              HasSubstr("\"status\": \"start_blocked\""));
  EXPECT_THAT(route({"--from", "1,1", "--to", "-6,4", "--json"}).out,
              HasSubstr("\"status\": \"goal_blocked\""));
}

TEST_F(QueryCommands, RouteAnswersATableOfQueries) {
  write_file(path("q.csv"), "x0,y0,x1,y1,r\n1.0,1,11,1,0.25\n6,4,1,1,0\n");

  const Outcome outcome = route({"--queries", path("q.csv"), "-o", path("a.csv"), "--repeat", "3"});

  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string answers = read_file(path("a.csv"));
  EXPECT_THAT(answers, StartsWith("x0,y0,x1,y1,r,status,length,clearance_min,microseconds\n"
                                  "1.0,1,11,1,0.25,ok,10,1,"));
  EXPECT_THAT(answers, HasSubstr("\n6,4,1,1,0,start_blocked,,,"));
}

TEST_F(QueryCommands, AFailedRunLeavesTheAnswersThatWereThere) {
  write_file(path("q.csv"), "x0,y0,x1,y1,r\n1,1,11,one,0.25\n");
  write_file(path("a.csv"), "kept");

  const Outcome outcome = route({"--queries", path("q.csv"), "-o", path("a.csv")});

  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("q.csv:2:8: error[csv-number]: 'one' is not a number"));
  EXPECT_EQ(read_file(path("a.csv")), "kept");
}

TEST_F(QueryCommands, ATableOfQueriesHoldsNumbersThatARadiusCanBe) {
  for (const char* bad : {"nan", "-1", "inf", "1e400", "0x1", ""}) {
    write_file(path("q.csv"), "x0,y0,x1,y1,r\n1,1,11,1," + std::string(bad) + "\n");

    const Outcome outcome = route({"--queries", path("q.csv"), "-o", path("a.csv")});

    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("q.csv:2:10: error[csv-number]: '" + std::string(bad) +
                                       "' is not a number of 0 or more"));
  }
}

TEST_F(QueryCommands, ATableOfAnotherEncodingIsNamed) {
  write_file(path("q.csv"), wide(U"\uFEFFx0,y0,x1,y1,r\n", 2, ByteOrder::Little));

  EXPECT_THAT(route({"--queries", path("q.csv"), "-o", path("a.csv")}).err,
              HasSubstr("q.csv:1:1: error[not-utf8]: is UTF-16 (little endian)"));
}

TEST_F(QueryCommands, RouteRefusesCommandLinesThatMakeNoSense) {
  EXPECT_EQ(route({"--from", "1,1"}).exit_code, 2);
  EXPECT_EQ(route({"--from", "1,1", "--to", "2;3"}).exit_code, 2);
  EXPECT_EQ(route({"--from", "1,1", "--to", "2,3", "--radius", "-1"}).exit_code, 2);
  EXPECT_EQ(route({"--exhibits", "no-such,other"}).exit_code, 2);
  EXPECT_EQ(route({"--from", "1,1", "--to", "2,3", "--floor", "attic"}).exit_code, 2);
  EXPECT_EQ(ask({"route", path("none.db"), "--kind", "shortest", "--from", "1,1", "--to", "2,2"})
                .exit_code,
            3);
}

TEST_F(QueryCommands, AtAndSeeAnswerTables) {
  write_file(path("p.csv"), "x,y\n1,4\n6,4\n");
  write_file(path("s.csv"), "x0,y0,x1,y1\n1,1,11,1\n1,4,11,4\n");

  EXPECT_EQ(ask({"at", path("hall.db"), "--points", path("p.csv"), "-o", path("at.csv")}).exit_code,
            0);
  EXPECT_EQ(
      ask({"see", path("hall.db"), "--pairs", path("s.csv"), "-o", path("see.csv")}).exit_code, 0);

  EXPECT_THAT(read_file(path("at.csv")), StartsWith("x,y,inside,clearance,region\n1,4,1,1,"));
  EXPECT_THAT(read_file(path("at.csv")), HasSubstr("\n6,4,0,1,"));
  EXPECT_THAT(read_file(path("see.csv")),
              StartsWith("x0,y0,x1,y1,visible,microseconds\n1,1,11,1,1,"));
  EXPECT_THAT(read_file(path("see.csv")), HasSubstr("\n1,4,11,4,0,"));
}

TEST_F(QueryCommands, OffsetCountsPartsAndHoles) {
  const Outcome outcome =
      ask({"offset", path("hall.db"), "--distance", "1", "--json", "--svg", path("offset.svg")});

  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, StartsWith("{\"components\": 1, \"holes\": 1, \"area\": 44.858"));
  EXPECT_THAT(read_file(path("offset.svg")), StartsWith("<svg"));
  EXPECT_EQ(ask({"offset", path("hall.db"), "--distance", "-1"}).exit_code, 2);
}

TEST_F(QueryCommands, RouteRoundsCornersWhenAskedTo) {
  const auto length = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"route", path("hall.db"), "--kind", "skeleton", "--from",
                                       "1,1",   "--to",          "11,1.5", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = ask(arguments);
    EXPECT_THAT(outcome.out, StartsWith("{\"status\": \"ok\", \"length\": ")) << outcome.err;
    return std::stod(outcome.out.substr(outcome.out.find("length") + 9));
  };

  EXPECT_LT(length({"--smooth"}), length({}));
}

TEST_F(QueryCommands, NearSaysThatNothingIsInReachOrWhatIsWrong) {
  const auto near = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"near", path("hall.db")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return ask(arguments);
  };

  EXPECT_EQ(near({"--from", "1,1"}).out, "no exhibit in reach\n");
  EXPECT_EQ(near({"--from", "1,1", "--json"}).out, "{\"status\": \"ok\", \"exhibits\": []}\n");
  EXPECT_EQ(near({"--from", "6,4"}).out, "start_blocked\n");
  EXPECT_EQ(near({}).exit_code, 2);
  EXPECT_EQ(near({"--from", "1,1", "--exhibit", "a"}).exit_code, 2);
  EXPECT_EQ(near({"--exhibit", "no-such"}).exit_code, 2);
  EXPECT_EQ(near({"--from", "1;1"}).exit_code, 2);
  EXPECT_EQ(near({"--from", "1,1", "--within", "-1"}).exit_code, 2);
  EXPECT_EQ(near({"--from", "1,1", "--speed", "0"}).exit_code, 2);
  EXPECT_EQ(near({"--from", "1,1", "--floor", "attic"}).exit_code, 2);
  EXPECT_EQ(ask({"near", path("none.db"), "--from", "1,1"}).exit_code, 3);
}

TEST(SampleMuseumNear, ListsExhibitsAsFarAsTheShortestWaysAre) {
  const std::string database = sample_database().string();
  const auto ask = [](const std::vector<std::string>& arguments) {
    const Outcome outcome = run(program("docent-content"), arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  };

  const auto all = ask({"near", database, "--exhibit", "tripod-ding", "--speed", "0.5", "--json"});

  ASSERT_GT(all["exhibits"].size(), 5U);
  double last = 0;
  for (const auto& row : all["exhibits"]) {
    EXPECT_NE(row["id"], "tripod-ding");
    const double length = row["length"];
    EXPECT_GE(length, last);
    EXPECT_NEAR(row["seconds"], length / 0.5, 1e-9);
    last = length;
  }
  const auto& second = all["exhibits"][1];
  const auto way = ask({"route", database, "--kind", "shortest", "--exhibits",
                        "tripod-ding," + second["id"].get<std::string>(), "--json"});
  EXPECT_NEAR(way["length"], second["length"].get<double>(), 1e-9);

  const double seconds = second["seconds"];
  const auto some = ask({"near", database, "--exhibit", "tripod-ding", "--speed", "0.5", "--within",
                         std::to_string(seconds + 0.01), "--json"});
  EXPECT_EQ(some["exhibits"].size(), 2U);
}

TEST(SampleMuseumRoute, PassesExhibitsInOrder) {
  const Outcome outcome =
      run(program("docent-content"), {"route", sample_database().string(), "--kind", "offset",
                                      "--exhibits", "boundary-stone,clay-letter,fish-mosaic"});

  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("ok: "));
}

}  // namespace
}  // namespace docent::test::query_commands_test
