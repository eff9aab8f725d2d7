// A plan on its way into a museum that staff own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/reference_data.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace docent::test::import_command_test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// Two rooms of 6 by 5 m side by side on each of two levels, a door between them, stairs in the
/// west rooms.
constexpr const char* house = R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"indoor": "room", "level": "0", "name": "West"}, "geometry": {"type": "Polygon", "coordinates": [[[0,0],[6,0],[6,5],[0,5],[0,0]]]}},
{"type": "Feature", "properties": {"indoor": "room", "level": "0", "name": "East"}, "geometry": {"type": "Polygon", "coordinates": [[[6,0],[12,0],[12,5],[6,5],[6,0]]]}},
{"type": "Feature", "properties": {"door": "yes", "level": "0"}, "geometry": {"type": "Point", "coordinates": [6, 2.5]}},
{"type": "Feature", "properties": {"indoor": "room", "level": "1", "name": "Above"}, "geometry": {"type": "Polygon", "coordinates": [[[0,0],[6,0],[6,5],[0,5],[0,0]]]}}
]})";

class Import {
 public:
  Import() { write("plan.geojson", house); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
  }
  fs::path museum() const { return folder_.path() / "museum"; }
  ProgramRun import(const std::string& file = "plan.geojson") const {
    return run_program("docent-content", "import '" + (folder_.path() / file).string() + "' -o '" +
                                             museum().string() + "' --json");
  }
  fs::path database() const { return folder_.path() / "museum.db"; }
  ProgramRun compile() const {
    return run_program("docent-content", "compile '" + museum().string() + "' -o '" +
                                             database().string() + "' --no-motion --quiet");
  }
  nlohmann::json route(const std::string& ends) const {
    const ProgramRun run = run_program(
        "docent-content", "route '" + database().string() + "' --kind shortest --json " + ends);
    return nlohmann::json::parse(run.out, nullptr, false);
  }

 private:
  TemporaryFolder folder_;
};

TEST(Import, TellsWhatItFoundAndWritesAMuseumThatCompiles) {
  const Import it;
  const ProgramRun run = it.import();
  ASSERT_EQ(run.exit_code, 0) << run.err;

  const auto told = nlohmann::json::parse(run.out);
  ASSERT_EQ(told["levels"].size(), 2U);
  EXPECT_EQ(told["levels"][0]["doors"], 1);
  ASSERT_EQ(told["levels"][0]["rooms"].size(), 2U);
  EXPECT_EQ(told["levels"][0]["rooms"][0]["name"], "West");
  EXPECT_NEAR(told["levels"][0]["rooms"][0]["area"].get<double>(), 30, 0.01);
  EXPECT_EQ(it.compile().exit_code, 0) << it.compile().err;
}

TEST(Import, LeavesAWallBetweenRoomsThatTouchWithAPassageAtTheDoor) {
  const Import it;
  ASSERT_EQ(it.import().exit_code, 0);
  ASSERT_EQ(it.compile().exit_code, 0) << it.compile().err;

  const auto route = it.route("--from 4,4.5 --to 8,4.5");

  ASSERT_EQ(route["status"], "ok");
  double nearest = 1e9;
  for (const auto& point : route["points"])
    nearest =
        std::min(nearest, std::hypot(point[0].get<double>() - 6, point[1].get<double>() - 2.5));
  EXPECT_LT(nearest, 0.6) << "it goes through the door";
  EXPECT_GT(route["length"].get<double>(), 4.9) << "and not straight through the wall";
}

/// The way ends on the outlines of both rooms, where a mapper would set the doors' nodes, and there
/// are none.
TEST(Import, LeadsIntoTheRoomsWhoseOutlinesAMappedWayTouches) {
  const Import it;
  it.write("plan.geojson", R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"indoor": "room", "level": "0", "name": "West"}, "geometry": {"type": "Polygon", "coordinates": [[[0,0],[6,0],[6,5],[0,5],[0,0]]]}},
{"type": "Feature", "properties": {"indoor": "room", "level": "0", "name": "East"}, "geometry": {"type": "Polygon", "coordinates": [[[12,0],[18,0],[18,5],[12,5],[12,0]]]}},
{"type": "Feature", "properties": {"highway": "footway", "level": "0"}, "geometry": {"type": "LineString", "coordinates": [[6,2],[9,4],[12,3]]}}]})");
  ASSERT_EQ(it.import().exit_code, 0);
  ASSERT_EQ(it.compile().exit_code, 0) << it.compile().err;

  EXPECT_EQ(it.route("--from 3,2.5 --to 15,2.5")["status"], "ok");
}

TEST(Import, AgainKeepsWhatStaffWroteAndSaysSo) {
  const Import it;
  ASSERT_EQ(it.import().exit_code, 0);
  std::string mine = text_of(it.museum() / "museum.toml");
  const std::size_t at = mine.find("\"West\"");
  ASSERT_NE(at, std::string::npos) << mine;
  mine.replace(at, 6, "\"The Armoury\"");
  std::ofstream(it.museum() / "museum.toml") << mine;

  const ProgramRun again = it.import();

  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(text_of(it.museum() / "museum.toml"), HasSubstr("\"The Armoury\""));
  EXPECT_THAT(again.err, HasSubstr("kept"));
}

/// Two of the reference data's schools have such rooms, traced by hand.
TEST(Import, OfARoomWhoseOutlineCrossesItselfWritesItsLargestPart) {
  const Import it;
  it.write("plan.geojson", R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"indoor": "room", "level": "0", "name": "Bow"}, "geometry": {"type": "Polygon", "coordinates": [[[0,0],[6,0],[6,5],[-1,5],[0,5.5],[0,0]]]}}]})");
  ASSERT_EQ(it.import().exit_code, 0);

  const ProgramRun compiled = it.compile();

  EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
  EXPECT_THAT(text_of(it.museum() / "museum.toml"),
              testing::AllOf(HasSubstr("[6, 5]"), testing::Not(HasSubstr("[-1, 5]"))));
}

/// Such as a station's platforms and doors: the file is no mistake, and holds no museum.
TEST(Import, OfAPlanWithoutRoomsSaysSoAndWritesNothing) {
  const Import it;
  it.write("plan.geojson", R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"door": "yes", "level": "0"}, "geometry": {"type": "Point", "coordinates": [6, 2.5]}}]})");

  const ProgramRun run = it.import();

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("no rooms"));
  EXPECT_FALSE(fs::exists(it.museum()));
}

TEST(Import, OfWhatIsNoPlanSaysWhatItIsAndWritesNothing) {
  const Import it;
  it.write("plan.pdf", "%PDF-1.7 and so on");

  const ProgramRun run = it.import("plan.pdf");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("a PDF"));
  EXPECT_FALSE(fs::exists(it.museum()));
}

}  // namespace
}  // namespace docent::test::import_command_test
