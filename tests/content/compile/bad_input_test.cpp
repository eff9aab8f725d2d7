// What staff are told when something is wrong, and that nothing that existed is lost.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/museum_folder.h"

namespace docent::compile::bad_input_test {
namespace {

using test::MuseumFolder;
using test::ProgramRun;
using test::run_program;
using test::text_of;
using testing::AllOf;
using testing::HasSubstr;

/// Compiles over an existing output, which has to survive.
ProgramRun failing_compile(const MuseumFolder& museum, const std::string& options = {}) {
  std::ofstream(museum.database()) << "what was there before";
  const ProgramRun run = museum.compile(options);
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_EQ(text_of(museum.database()), "what was there before");
  return run;
}

TEST(BadInput, AnExhibitOutsideTheBuilding) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "[10.0, 4.0]", "[10.50, 4.00]");

  const ProgramRun run = failing_compile(museum);

  EXPECT_THAT(
      run.err,
      AllOf(HasSubstr("hall.toml:13:12: error[exhibit-outside-floor]: exhibit 'portrait' stands "
                      "outside the building"),
            HasSubstr("    13 | position = [10.50, 4.00]"),
            HasSubstr("       |            ^^^^^^^^^^^^^ 0.50 m outside the floor of 'ground'"),
            HasSubstr("   hint: the nearest free point is [10.00, 4.00]")));
}

TEST(BadInput, AnExhibitThatNoVisitorCanReach) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "[10.0, 4.0]", "[14.0, 2.0]");  // in the closet

  const ProgramRun run = failing_compile(museum);

  EXPECT_THAT(run.err, AllOf(HasSubstr("hall.toml:13:12: error[exhibit-unreachable]: no visitor "
                                       "can reach exhibit 'portrait' from the kiosk"),
                             HasSubstr("hint: every way from the kiosk to")));
}

TEST(BadInput, AnExhibitThatLooksAtTheWall) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "facing = 180", "facing = 0");

  EXPECT_THAT(failing_compile(museum).err,
              AllOf(HasSubstr("hall.toml:14:10: error[exhibit-unreachable]: exhibit 'portrait' "
                              "cannot be looked at from the front"),
                    HasSubstr("turn 'facing' towards free floor")));
}

TEST(BadInput, AViewingPointWithoutRoomForAVisitor) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "facing = 180", "facing = 180\nview = [9.9, 4.0]");

  EXPECT_THAT(failing_compile(museum).err,
              AllOf(HasSubstr("hall.toml:15:8: error[exhibit-unreachable]"),
                    HasSubstr("0.10 m from a wall"),
                    HasSubstr("the nearest point with room for a visitor is [9.70, 4.00]")));
}

TEST(BadInput, AKioskInAWall) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "position = [2.0, 2.0]", "position = [-3.0, 2.0]");

  EXPECT_THAT(failing_compile(museum).err,
              AllOf(HasSubstr("museum.toml:9:12: error[kiosk-outside-floor]"),
                    HasSubstr("3.00 m outside the floor")));
}

TEST(BadInput, OneOfSeveralKiosksInAWall) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "[kiosk]\n",
                 "[[kiosk]]\nid = \"cafe\"\nposition = [3, 6]\n[[kiosk]]\nid = \"foyer\"\n");
  museum.replace("museum.toml", "position = [2.0, 2.0]", "position = [-3.0, 2.0]");

  EXPECT_THAT(failing_compile(museum).err,
              AllOf(HasSubstr("museum.toml:13:12: error[kiosk-outside-floor]"),
                    HasSubstr("nobody can stand where the kiosk 'foyer' is said to be")));
}

TEST(BadInput, TwoExhibitsWithOneId) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "\"portrait\"", "\"jade-disc\"");

  EXPECT_THAT(failing_compile(museum).err,
              HasSubstr("hall.toml:12:6: error[duplicate-id]: there are two exhibits with the id "
                        "'jade-disc'"));
}

TEST(BadInput, ATypoInMuseumToml) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "facing", "fcaing");

  EXPECT_THAT(failing_compile(museum).err,
              AllOf(HasSubstr("museum.toml:10:1: error[unknown-key]: [kiosk] has no 'fcaing'"),
                    HasSubstr("hint: did you mean 'facing'?")));
}

TEST(BadInput, AMissingImage) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "images/disc.svg", "images/none.svg");

  EXPECT_THAT(failing_compile(museum).err,
              HasSubstr("hall.toml:5:9: error[missing-file]: there is no file 'images/none.svg'"));
}

TEST(BadInput, AnImageThatIsNone) {
  const MuseumFolder museum;
  museum.write("images/disc.svg", "not a picture");

  EXPECT_THAT(failing_compile(museum).err, HasSubstr("hall.toml:5:9: error[unreadable-image]"));
}

TEST(BadInput, AMissingTranslation) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "title.ar = \"صورة\"\n", "");

  EXPECT_THAT(failing_compile(museum).err,
              AllOf(HasSubstr("hall.toml:16:12: error[missing-translation]: the title of exhibit "
                              "'portrait' is not translated into 'ar'"),
                    HasSubstr("hint: translate from 'en': Portrait")));
}

TEST(BadInput, ALanguageThatTheInterfaceDoesNotSpeak) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "[\"en\", \"ar\"]", "[\"en\", \"ar\", \"tlh\"]");

  EXPECT_THAT(failing_compile(museum).err,
              HasSubstr("there are no words of the interface in 'tlh'"));
}

TEST(BadInput, APlanThatIsNoGeoJson) {
  const MuseumFolder museum;
  museum.write("ground.geojson", "{\"type\": \"Polygon\",\n \"coordinates\": 5}");

  EXPECT_THAT(failing_compile(museum).err, HasSubstr("ground.geojson:2:"));
}

TEST(BadInput, APlanThatCrossesItselfIsMendedAndTold) {
  const MuseumFolder museum;
  museum.replace("ground.geojson", "[10, 8], [0, 8], [0, 0]]",
                 "[10, 8], [0, 8], [0, 3], [-1, 1], [0, 1], [-1, 3], [0, 2.5], [0, 0]]");

  const ProgramRun run = museum.compile();

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("ground.geojson:3:"));
  EXPECT_THAT(run.err, HasSubstr("warning["));
}

TEST(BadInput, AnEmptyClipsFolder) {
  const MuseumFolder museum;
  const test::TemporaryFolder empty;

  const ProgramRun run =
      run_program("docent-content", "compile '" + museum.path().string() + "' -o '" +
                                        museum.database().string() + "' --quiet --clips '" +
                                        empty.path().string() + "'");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("error[no-clips]: this folder holds no motion"));
  EXPECT_FALSE(std::filesystem::exists(museum.database()));
}

TEST(BadInput, ABvhCutInTheMiddle) {
  const MuseumFolder museum;
  const test::TemporaryFolder clips;
  const std::string whole = text_of(test::source_dir() / "content/clips/walk.bvh");
  ASSERT_FALSE(whole.empty());
  std::ofstream(clips.path() / "walk.bvh") << whole.substr(0, whole.size() / 2);

  const ProgramRun run =
      run_program("docent-content", "compile '" + museum.path().string() + "' -o '" +
                                        museum.database().string() + "' --quiet --clips '" +
                                        clips.path().string() + "'");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, testing::ContainsRegex("walk\\.bvh:[0-9]+:[0-9]+: error"));
  EXPECT_FALSE(std::filesystem::exists(museum.database()));
}

TEST(BadInput, MoreStrollingVisitorsThanThereIsRoomFor) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "count = 3", "count = 100000");

  // Of 10 by 8 metres a case takes one square metre; the closet is not joined to the room.
  EXPECT_THAT(failing_compile(museum).err,
              AllOf(HasSubstr("museum.toml:12:9: error[too-many-visitors]: 100000 visitors cannot "
                              "stroll here: 19 fit"),
                    HasSubstr("hint: write count = 19 or less: each wants 4 of the 79 square "
                              "metres about the kiosk, and 56 is the most anywhere")));
}

TEST(BadInput, FewerStrollingVisitorsThanNone) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "count = 3", "count = -3");

  EXPECT_THAT(failing_compile(museum).err,
              HasSubstr("museum.toml:12:9: error[out-of-range]: 'count' should be at least 0"));
}

TEST(BadInput, HalfAStrollingVisitor) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "count = 3", "count = 2.5");

  EXPECT_THAT(failing_compile(museum).err,
              HasSubstr("museum.toml:12:9: error[wrong-type]: 'count' should be a whole number"));
}

TEST(BadInput, StrollingVisitorsWhoLookLongerAtLeastThanAtMost) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "count = 3", "count = 3\nlook = [20, 6]");

  EXPECT_THAT(failing_compile(museum).err,
              AllOf(HasSubstr("museum.toml:13:8: error[bad-value]: the least of 'look' is above "
                              "its most"),
                    HasSubstr("hint: write look = [6, 20]")));
}

TEST(BadInput, StrollingVisitorsWhoComeThroughAWall) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "count = 3",
                 "count = 3\nfrom = [[1, 1], [5, 0],\n        [11, 2]]");

  EXPECT_THAT(
      failing_compile(museum).err,
      AllOf(HasSubstr("museum.toml:13:17: error[entrance-outside-floor]: strolling visitors cannot "
                      "come from here: nobody can stand here"),
            HasSubstr("0.00 m from a wall"),
            HasSubstr("hint: the nearest point with room for a visitor is [5.00, 0.30]"),
            HasSubstr("museum.toml:14:9: error[entrance-outside-floor]"),
            HasSubstr("1.00 m outside the floor")));
}

TEST(BadInput, StrollingVisitorsWhoComeFromWhereNobodyGetsOut) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "count = 3", "count = 3\nfrom = [14, 2]");  // the closet

  EXPECT_THAT(failing_compile(museum).err,
              AllOf(HasSubstr("museum.toml:13:8: error[entrance-unreachable]: strolling visitors "
                              "cannot come from here: there is no way to the kiosk"),
                    HasSubstr("hint: every way from here to the kiosk is narrower than 0.50 m")));
}

/// Gives the closet a name and a doorway of 0.62 m to the hall, and the guide a radius of 0.4 m.
void open_the_closet(const MuseumFolder& museum) {
  museum.replace("ground.geojson", "[[[12, 0]",
                 "[[[10, 1], [12, 1], [12, 1.62], [10, 1.62], [10, 1]]], [[[12, 0]");
  museum.replace("museum.toml", "[ambient]", "[avatar]\nradius = 0.4\n[ambient]");
  museum.replace("museum.toml", "[[room]]",
                 "[[room]]\nid = \"closet\"\nlabel = [14, 2]\n"
                 "title.en = \"Jade Room\"\ntitle.ar = \"غرفة اليشم\"\n"
                 "outline = [[12, 0], [16, 0], [16, 4], [12, 4]]\n[[room]]");
}

TEST(BadInput, AGuideThatIsTooWideForADoor) {
  const MuseumFolder museum;
  open_the_closet(museum);
  museum.replace("exhibits/hall.toml", "[10.0, 4.0]", "[16.0, 2.0]");

  EXPECT_THAT(
      failing_compile(museum).err,
      AllOf(HasSubstr("museum.toml:12:10: error[guide-too-wide]: the guide, 0.80 m wide, does not "
                      "fit through the door between 'Jade Room' and 'Hall' (0.62 m)"),
            HasSubstr("hint: under [avatar] write radius = 0.31 or less, or widen the door in "
                      "ground.geojson"),
            HasSubstr("no visitor can reach exhibit 'portrait' from the kiosk")));
}

TEST(BadInput, ADoorThatIsTooNarrowMattersLessWithoutAnExhibitBehindIt) {
  const MuseumFolder museum;
  open_the_closet(museum);

  const ProgramRun run = museum.compile();

  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("warning[guide-too-wide]"));
  museum.replace("museum.toml", "radius = 0.4", "radius = 0.31");
  EXPECT_EQ(museum.compile().err, "");
}

TEST(BadInput, AllMistakesOfAllFilesInOneRun) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "count = 3", "count = -2000");
  museum.replace("exhibits/hall.toml", "[10.0, 4.0]", "[10.5, 4.0]");
  museum.replace("exhibits/hall.toml", "text.ar = \"قرص.\"\n", "");

  const ProgramRun run = failing_compile(museum, "--json");

  EXPECT_EQ(std::ranges::count(run.err, '\n'), 3) << run.err;
  EXPECT_THAT(run.err, testing::ContainsRegex("out-of-range.*\n.*missing-translation.*\n.*"
                                              "exhibit-outside-floor"));
}

TEST(BadInput, AnImageThatIsAFolder) {
  const MuseumFolder museum;
  museum.replace("exhibits/hall.toml", "image = \"images/disc.svg\"", "image = \"images\"");

  EXPECT_THAT(failing_compile(museum).err,
              AllOf(HasSubstr("hall.toml:5:9: error[bad-path]: 'images' is a folder"),
                    HasSubstr("hint: name a file in it")));
}

TEST(BadInput, APlanThatIsAFolder) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "plan = \"ground.geojson\"", "plan = \"images\"");

  EXPECT_THAT(failing_compile(museum).err,
              HasSubstr("museum.toml:7:8: error[bad-path]: 'images' is a folder"));
}

TEST(BadInput, AMuseumFolderBesideAnotherSource) {
  const MuseumFolder museum;

  const ProgramRun run =
      run_program("docent-content", "check '" + museum.path().string() + "' extra.geojson --quiet");

  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr(museum.path().string() + ": error[folder-among-sources]"),
                             HasSubstr("hint: name one museum's folder alone")));
}

TEST(BadInput, AFolderWhereAFileOfPointsIsWanted) {
  const MuseumFolder museum;
  ASSERT_EQ(museum.compile().exit_code, 0);

  const ProgramRun run =
      run_program("docent-content", "at '" + museum.database().string() + "' --points '" +
                                        museum.path().string() + "' -o a.csv");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("is a folder; name a file"));
}

TEST(BadInput, AnOutputFolderThatIsNotThere) {
  const MuseumFolder museum;

  const ProgramRun run =
      run_program("docent-content",
                  "compile '" + museum.path().string() + "' -o /no/such/m.db --no-motion --quiet");

  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("the folder '/no/such' does not exist"));
}

TEST(BadInput, ACommandLineThatIsWrong) {
  EXPECT_EQ(run_program("docent-content", "").exit_code, 2);
  EXPECT_EQ(run_program("docent-content", "compile").exit_code, 2);
  EXPECT_EQ(run_program("docent-content", "compile a -o b --radius -1").exit_code, 2);
  EXPECT_EQ(run_program("docent-content", "compile a -o b --coordinates feet").exit_code, 2);
  EXPECT_EQ(run_program("docent-content", "info").exit_code, 2);
  EXPECT_EQ(run_program("docent-content", "--help").exit_code, 0);
}

TEST(BadInput, ADatabaseThatIsMissingOrDamaged) {
  const MuseumFolder museum;
  ASSERT_EQ(museum.compile().exit_code, 0);
  std::string bytes = text_of(museum.database());
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(museum.path() / "flipped.db", std::ios::binary) << bytes;
  std::ofstream(museum.path() / "short.db", std::ios::binary) << bytes.substr(0, 9000);
  const auto info = [&](const char* file) {
    return run_program("docent-content", "info '" + (museum.path() / file).string() + "'");
  };

  EXPECT_EQ(info("none.db").exit_code, 3);
  EXPECT_THAT(info("none.db").err, HasSubstr("there is no such database"));
  EXPECT_EQ(info("flipped.db").exit_code, 1);
  EXPECT_THAT(info("flipped.db").err, HasSubstr("is damaged (its checksum does not match)"));
  EXPECT_EQ(info("short.db").exit_code, 1);
  EXPECT_THAT(info("short.db").err, HasSubstr("is cut short (9000 of"));
}

}  // namespace
}  // namespace docent::compile::bad_input_test
