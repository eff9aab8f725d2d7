#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "platform/sqlite/content_reader.h"
#include "runtime/path/building/building_map.h"
#include "runtime/path/route.h"
#include "runtime/schema/schema.h"
#include "tests/support/museum_folder.h"

namespace docent::compile::compile_test {
namespace {

using test::MuseumFolder;
using test::run_program;
using test::text_of;
using testing::Each;
using testing::HasSubstr;

Museum compiled(const MuseumFolder& folder) {
  const test::ProgramRun run = folder.compile();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  Result<Museum> museum = sqlite::load_museum(folder.database());
  EXPECT_TRUE(museum.has_value());
  return museum.value_or(Museum{});
}

TEST(Compile, TurnsAFolderIntoAMuseum) {
  const Museum museum = compiled(MuseumFolder());

  ASSERT_EQ(museum.exhibits.size(), 2U);
  EXPECT_EQ(museum.title.at("en"), "Small Museum");
  EXPECT_EQ(museum.languages.at(1).tag, "ar");
  EXPECT_TRUE(museum.languages.at(1).right_to_left) << "the shipped words say so";
  EXPECT_FALSE(museum.languages.at(0).words.empty());
  EXPECT_EQ(museum.ambient.count, 3U);
  EXPECT_THAT(museum.ambient.entrances, testing::IsEmpty());
  EXPECT_EQ(museum.exhibits[0].place, ExhibitPlace::OnFloor) << "a pedestal of a metre, no glass";
  EXPECT_EQ(museum.exhibits[1].place, ExhibitPlace::OnWall);
  EXPECT_EQ(museum.exhibits[0].image, museum.exhibits[1].image) << "one file is one image";
  EXPECT_EQ(museum.rooms.at(museum.exhibits[1].room).id, "hall");
  EXPECT_NEAR(museum.kiosk.heading, std::numbers::pi / 2, 1e-12);
}

TEST(Compile, KeepsFurtherPicturesInTheirOrderBehindThoseOfTheModel) {
  const MuseumFolder folder;
  for (const char* name : {"images/back.svg", "images/rim.svg"})
    folder.write(name, text_of(folder.path() / "images/disc.svg"));
  folder.replace(
      "exhibits/hall.toml", "title.en = \"Jade disc\"",
      "pictures = [{image = \"images/rim.svg\"}, {image = \"images/back.svg\", caption = "
      "{en = \"Back\", ar = \"الظهر\"}}]\ntitle.en = \"Jade disc\"");
  const Museum museum = compiled(folder);

  ASSERT_EQ(museum.pictures.size(), 2U);
  const auto name_of = [&](const FurtherPicture& picture) {
    return museum.images.at(picture.image).name;
  };
  EXPECT_EQ(name_of(museum.pictures[0]), "images/rim.svg");
  EXPECT_EQ(name_of(museum.pictures[1]), "images/back.svg");
  EXPECT_EQ(museum.pictures[1].caption.at("ar"), "الظهر");
  EXPECT_EQ(museum.pictures[1].exhibit, 0U);
  for (const Exhibit& exhibit : museum.exhibits)
    EXPECT_LT(exhibit.image, museum.pictures[0].image) << "the model's have the first indices";
}

TEST(Compile, TakesWordsThatAMuseumsOwnFileLacksFromThoseThatShip) {
  const MuseumFolder folder;
  folder.write(
      "words/en.toml",
      "name = \"English\"\ndirection = \"left-to-right\"\n[words]\nbegin = \"Press here\"\n");
  const Museum museum = compiled(folder);

  ASSERT_FALSE(museum.languages.empty());
  EXPECT_EQ(museum.languages[0].words.at("begin"), "Press here");
  EXPECT_EQ(museum.languages[0].words.at("staff_title"), "For staff");
}

TEST(Compile, PlacesEachOfSeveralKiosks) {
  const MuseumFolder folder;
  folder.replace("museum.toml", "[kiosk]\n",
                 "[[kiosk]]\nid = \"cafe\"\nposition = [3, 6]\nfacing = 180\n"
                 "[[kiosk]]\nid = \"foyer\"\n");

  Museum museum = compiled(folder);

  ASSERT_EQ(museum.kiosks.size(), 2U);
  EXPECT_EQ(museum.kiosk.position, Vec2(3, 6)) << "the first, where kiosk.toml does not say";
  ASSERT_TRUE(stand_at(museum, "foyer"));
  EXPECT_EQ(museum.kiosk.position, Vec2(2, 2));
  EXPECT_NEAR(museum.kiosk.heading, std::numbers::pi / 2, 1e-12);
}

TEST(Compile, KeepsWhereStrollingVisitorsComeFromAndHowLongTheyLook) {
  const MuseumFolder folder;
  folder.replace("museum.toml", "count = 3", "count = 5\nfrom = [[1, 4], [9, 1.5]]\nlook = [3, 8]");

  const Ambient ambient = compiled(folder).ambient;

  EXPECT_EQ(ambient.count, 5U);
  EXPECT_THAT(ambient.entrances, testing::ElementsAre(Vec2(1, 4), Vec2(9, 1.5)));
  EXPECT_EQ(ambient.look_least, 3);
  EXPECT_EQ(ambient.look_most, 8);
}

/// A visitor stands in front of the exhibit, facing it, with room for the body, and can get there.
void expect_good_view(const Museum& museum, const Exhibit& exhibit,
                      const path::BuildingMap& building) {
  const path::FloorMap& map = building.floor(exhibit.floor);
  const Vec2 view = exhibit.viewing_point.position;
  const Vec2 to_object = exhibit.placement.position - view;
  const Vec2 facing{std::cos(exhibit.viewing_point.heading),
                    std::sin(exhibit.viewing_point.heading)};
  EXPECT_TRUE(path::is_inside(map, view)) << exhibit.id;
  EXPECT_GE(path::clearance_at(map, view), museum.body_radius) << exhibit.id;
  EXPECT_NEAR(dot(facing, to_object), glm::length(to_object), 1e-9) << exhibit.id;
  EXPECT_GE(glm::length(to_object), 0.79) << exhibit.id;
  const path::BuildingQuery query{
      .way = {.from = museum.kiosk.position, .to = view, .radius = museum.body_radius},
      .from_floor = museum.kiosk_floor,
      .to_floor = exhibit.floor};
  EXPECT_EQ(building.route(query).status, path::BuildingStatus::Ok) << exhibit.id;
}

TEST(Compile, FindsAViewingPointForEveryExhibitOfTheSampleMuseum) {
  const test::TemporaryFolder folder;
  const std::string database = (folder.path() / "sample.db").string();
  const auto run =
      run_program("docent-content", "compile '" + (test::source_dir() / "config/museum").string() +
                                        "' -o '" + database + "' --no-motion --quiet");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Result<Museum> museum = sqlite::load_museum(database);
  ASSERT_TRUE(museum.has_value());
  std::vector<std::shared_ptr<const path::FloorMap>> maps;
  for (const Floor& floor : museum->floors) maps.push_back(path::make_floor_map(floor));
  const path::BuildingMap building(*museum, std::move(maps));

  EXPECT_GE(museum->exhibits.size(), 35U);
  for (const Exhibit& exhibit : museum->exhibits) expect_good_view(*museum, exhibit, building);
  EXPECT_LT(std::filesystem::file_size(database), 20U << 20U);
}

TEST(Compile, GivesTheSameBytesForAnyNumberOfThreads) {
  const MuseumFolder museum;
  ASSERT_EQ(museum.compile("--jobs 1").exit_code, 0);
  const std::string one = text_of(museum.database());
  ASSERT_EQ(museum.compile("--jobs 2").exit_code, 0);

  EXPECT_EQ(text_of(museum.database()), one);
}

TEST(Compile, MakesAMuseumWithoutExhibitsOfAPlanAlone) {
  const MuseumFolder museum;
  const test::ProgramRun run = run_program(
      "docent-content", "compile '" + (museum.path() / "ground.geojson").string() + "' -o '" +
                            museum.database().string() + "' --no-motion --radius 0.4 --quiet");

  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Result<Museum> plan = sqlite::load_museum(museum.database());
  ASSERT_TRUE(plan.has_value()) << plan.error().what;
  EXPECT_EQ(plan->floors.at(0).plan.name, "ground");
  ASSERT_EQ(plan->floors[0].tangent_graphs.size(), 3U);
  EXPECT_EQ(plan->floors[0].tangent_graphs[1].radius, 0.25);
  EXPECT_EQ(plan->floors[0].tangent_graphs[2].radius, 0.4);
}

TEST(Compile, TellsSecondsAndBytesOfEachStage) {
  const test::ProgramRun run = MuseumFolder().compile("--json");

  ASSERT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, testing::MatchesRegex(
                           R"(\{"stages":\[\{"stage":"plan","seconds":[0-9.e-]+,"bytes":[0-9]+.*)"
                           R"("bytes":[0-9]+\}.)"));
}

TEST(Check, ReportsAndWritesNothing) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "count = 3", "count = -1");

  const test::ProgramRun run =
      run_program("docent-content", "check '" + museum.path().string() + "' --quiet --no-motion");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("error[out-of-range]"));
  EXPECT_FALSE(std::filesystem::exists(museum.database()));
}

TEST(Info, CountsWhatADatabaseHolds) {
  const MuseumFolder museum;
  ASSERT_EQ(museum.compile().exit_code, 0);

  const test::ProgramRun run =
      run_program("docent-content", "info '" + museum.database().string() + "' --json");

  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, HasSubstr(fmt::format(R"("schema_version":{},)", schema::version)));
  EXPECT_THAT(run.out, HasSubstr(R"("floors":1,"exhibits":2)"));
  EXPECT_THAT(run.out, HasSubstr(R"("exhibit_ids":["jade-disc","portrait"])"));
  EXPECT_THAT(run.out, HasSubstr(R"("sites":16,)")) << "12 walls and the case's 4 corners";
  EXPECT_THAT(run.out, HasSubstr(R"("skeleton_length":)"));
}

}  // namespace
}  // namespace docent::compile::compile_test
