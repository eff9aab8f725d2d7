// docent-content route through a building.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/house_folder.h"
#include "tests/support/run_program.h"

namespace docent::command::route_command_test {
namespace {

using nlohmann::json;
using test::ProgramRun;
using testing::HasSubstr;

class RouteThroughAHouse : public ::testing::Test {
 protected:
  ProgramRun route(const std::string& question) const {
    return test::run_program("docent-content",
                             fmt::format("route '{}' {}", house_.database().string(), question));
  }
  json answer(const std::string& question) const {
    const ProgramRun run = route("--json " + question);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return json::parse(run.out, nullptr, false);
  }
  void compile() const { ASSERT_EQ(house_.compile().exit_code, 0); }

  test::HouseFolder house_;
};

TEST_F(RouteThroughAHouse, ListsItsFloorsAndWhatJoinsThem) {
  compile();

  const json way = answer("--kind shortest --exhibits vase,sword");

  EXPECT_EQ(way["status"], "ok");
  EXPECT_EQ(way["floors"], json({"ground", "upper"}));
  ASSERT_EQ(way["legs"].size(), 3U);
  EXPECT_EQ(way["legs"][0]["floor"], "ground");
  EXPECT_EQ(way["legs"][0]["points"], json::parse("[[6.0, 4.0], [1.0, 4.0]]"));
  EXPECT_EQ(way["legs"][1], json::parse(R"({"connection": "stairs", "kind": "stairs",
                                            "from": "ground", "to": "upper", "seconds": 20.0})"));
  EXPECT_EQ(way["legs"][2]["floor"], "upper");
  EXPECT_EQ(way["length"], 5 + 10 + 5);
  EXPECT_EQ(way["seconds"], 5 + 20 + 5);
  EXPECT_EQ(way["points"].size(), 4U);
}

TEST_F(RouteThroughAHouse, TakesTheLiftWhereThereMustBeNoSteps) {
  compile();

  EXPECT_THAT(route("--kind skeleton --exhibits vase,sword --step-free").out,
              HasSubstr("by lift from ground to upper"));
  EXPECT_EQ(answer("--kind shortest --exhibits vase,sword --metric length")["length"], 10);
}

TEST_F(RouteThroughAHouse, GoesFromFloorToFloorBetweenPoints) {
  compile();

  const json way =
      answer("--kind offset --from 2,2 --to 10,6 --from-floor upper --to-floor ground");

  EXPECT_EQ(way["floors"], json({"upper", "ground"}));
  EXPECT_THAT(route("--kind shortest --from 2,2 --to 10,6 --to-floor attic").err,
              HasSubstr("the floors are: ground, upper"));
}

TEST_F(RouteThroughAHouse, SaysWhatIsClosed) {
  house_.replace("museum.toml", "kind = \"lift\"", "kind = \"lift\"\nclosed = true");
  compile();

  const json way = answer("--kind shortest --exhibits vase,sword --step-free");

  EXPECT_EQ(way["status"], "closed");
  EXPECT_EQ(way["closed"], json({"lift"}));
  EXPECT_EQ(way["length"], nullptr);
  EXPECT_EQ(route("--kind shortest --exhibits vase,sword --step-free").out, "closed: lift\n");
}

TEST_F(RouteThroughAHouse, SaysThatThereAreOnlySteps) {
  house_.replace("museum.toml", "kind = \"lift\"", "kind = \"stairs\"");
  compile();

  EXPECT_EQ(answer("--kind shortest --exhibits vase,sword --step-free")["status"], "no_step_free");
}

TEST_F(RouteThroughAHouse, LeadsRoundAClosedDoorByTheFloorAbove) {
  house_.write(
      "hall.geojson",
      "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [12, 0], [12, 8], [0, 8], [0, 0]],"
      " [[8, 0], [8, 3], [8.2, 3], [8.2, 0], [8, 0]], [[8, 5], [8, 8], [8.2, 8], [8.2, 5], [8, "
      "5]]]}\n");
  const std::string door =
      "[[door]]\nname = \"east door\"\nfloor = \"ground\"\na = [8.1, 3]\nb = [8.1, 5]\n";
  house_.replace("museum.toml", "[[connection]]", door + "[[connection]]");
  compile();
  const std::string question = "--kind shortest --from 6,4 --to 10,4";
  EXPECT_EQ(answer(question)["length"], 4);
  house_.replace("museum.toml", "b = [8.1, 5]", "b = [8.1, 5]\nclosed = true");

  compile();

  const json way = answer(question);
  EXPECT_EQ(way["status"], "ok");
  EXPECT_EQ(way["floors"], json({"ground", "upper", "ground"}));
  EXPECT_NEAR(way["length"].get<double>(), 5 + 10 + 10 + 0 + 1, 1e-9);
}

TEST_F(RouteThroughAHouse, HeedsHoursAndWhatIsClosedToday) {
  house_.replace("museum.toml", "kind = \"lift\"",
                 "kind = \"lift\"\nhours = \"Mo-Fr 10:00-18:00\"");
  compile();
  house_.write("today.toml", "[[closed]]\nconnection = \"stairs\"\nuntil = 2026-11-23T17:00:00\n");
  const std::string ask = "--kind shortest --exhibits vase,sword ";
  const std::string today = " --today '" + (house_.path() / "today.toml").string() + "'";

  EXPECT_THAT(route(ask + "--step-free --at 2026-11-23T12:00").out, HasSubstr("by lift"));
  EXPECT_EQ(answer(ask + "--step-free --at 2026-11-23T18:00")["closed"], json({"lift"}));
  EXPECT_EQ(answer(ask + "--step-free")["status"], "ok") << "no time, no hours";
  EXPECT_THAT(route(ask + today).out, HasSubstr("by lift"));
  const json late = answer(ask + "--at 2026-11-22T16:59" + today);
  EXPECT_EQ(late["status"], "closed");
  EXPECT_EQ(late["closed"], json({"stairs"}));
  EXPECT_THAT(route(ask + "--at 2026-11-23T17:00" + today).out, HasSubstr("by stairs"));
  EXPECT_EQ(route(ask + "--at tomorrow").exit_code, 2);
}

TEST_F(RouteThroughAHouse, NamesTheDoorThatIsClosedForGood) {
  house_.write(
      "hall.geojson",
      "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [12, 0], [12, 8], [0, 8], [0, 0]],"
      " [[8, 0], [8, 3], [8.2, 3], [8.2, 0], [8, 0]], [[8, 5], [8, 8], [8.2, 8], [8.2, 5], [8, "
      "5]]]}\n");
  house_.replace("museum.toml", "[[connection]]",
                 "[[door]]\nid = \"gate\"\na = [8.1, 3]\nb = [8.1, 5]\nclosed = true\n"
                 "[[connection]]");
  house_.replace("museum.toml", "kind = \"lift\"", "kind = \"lift\"\nclosed = true");
  compile();

  const json way = answer("--kind shortest --from 6,4 --to 10,4");

  EXPECT_EQ(way["status"], "closed");
  EXPECT_EQ(way["closed"], json({"lift"})) << "by the floor above, if the lift were open";
  const json to_gate = answer(
      "--kind skeleton --from 6,4 --from-floor ground --to 10,4 --no-escalators "
      "--to-floor ground");
  EXPECT_EQ(to_gate["status"], "closed");
}

TEST_F(RouteThroughAHouse, RefusesAFaultyTodayWithASentence) {
  compile();
  house_.write("today.toml", "[[closed]]\ndoor = \"gate\"\n");

  const ProgramRun run = route("--kind shortest --exhibits vase,sword --today '" +
                               (house_.path() / "today.toml").string() + "'");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err,
              HasSubstr("today.toml:2:8: error[unknown-id]: the museum has no door 'gate'"));
}

TEST_F(RouteThroughAHouse, LeadsToTheNearestPlaceOfAKind) {
  house_.replace("museum.toml", "[kiosk]",
                 "[[place]]\nid = \"wc\"\nkind = \"accessible_toilets\"\nfloor = \"upper\"\n"
                 "position = [2, 4]\n[[place]]\nid = \"far-wc\"\nkind = \"toilets\"\n"
                 "position = [11, 7]\n[kiosk]");
  compile();

  const json way = answer("--kind shortest --from 1,3 --to-place toilets");
  EXPECT_EQ(way["place"], "far-wc") << "10.8 s along the floor, 22 s by the stairs";
  EXPECT_EQ(way["status"], "ok");
  EXPECT_EQ(answer("--kind shortest --from 1,3 --to-place accessible_toilets")["place"], "wc");
  EXPECT_EQ(answer("--kind skeleton --from 1,3 --from-floor upper --to-place toilets")["place"],
            "wc");
  EXPECT_THAT(route("--kind shortest --from 1,3 --to-place cafe").err,
              HasSubstr("has no place of the kind 'cafe'"));
  EXPECT_EQ(route("--kind shortest --from 1,3 --to 2,2 --to-place toilets").exit_code, 2);
}

TEST_F(RouteThroughAHouse, JoinsToursOfSeveralFloors) {
  compile();

  const json way = answer("--kind shortest --exhibits vase,sword,vase");

  EXPECT_EQ(way["floors"], json({"ground", "upper", "ground"}));
  EXPECT_EQ(way["seconds"], 60);
}

}  // namespace
}  // namespace docent::command::route_command_test
