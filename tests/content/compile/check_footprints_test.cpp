#include "content/compile/check_footprints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "content/compile/compile_floor.h"
#include "tests/support/temporary_folder.h"

namespace docent::compile::check_footprints_test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr double body = 0.25;

/// Two rooms of 8 by 8 m: a door of 1.4 m between them in the south and, where it is said, one in
/// the north.
constexpr const char* west = "[[[0, 0], [8, 0], [8, 8], [0, 8], [0, 0]]]";
constexpr const char* east = "[[[8.4, 0], [16.4, 0], [16.4, 8], [8.4, 8], [8.4, 0]]]";
constexpr const char* south_door = "[[[8, 1], [8.4, 1], [8.4, 2.4], [8, 2.4], [8, 1]]]";
constexpr const char* north_door = "[[[8, 6], [8.4, 6], [8.4, 7.4], [8, 7.4], [8, 6]]]";
const std::string one_way = std::string(west) + ", " + east + ", " + south_door;
const std::string two_ways = one_way + ", " + north_door;

/// A free exhibit.
Standing thing(const std::string& name, Vec2 at, Vec2 size = {0.6, 0.6}) {
  return {.name = name, .footprint = {.centre = at, .heading = 0, .size = size}, .place = {}};
}

struct Furnished {
  CompiledFloor compiled;
  std::shared_ptr<const path::FloorMap> map;
  std::vector<ClosedPassage> passages;
};

Furnished furnished(const std::string& areas, std::vector<Standing> things) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "floor.geojson").string();
  std::ofstream(file) << R"({"type": "MultiPolygon", "coordinates": [)" << areas << "]}";
  Report report;
  Progress progress(Progress::Output::Nothing);
  plan_floor_stages(progress);
  Furnished result;
  result.compiled = compile_floor("floor", std::span(&file, 1), import::Coordinates::Metres,
                                  std::vector{0.0, body}, report, progress, 1,
                                  {.doors = {}, .standing = std::move(things)});
  result.map = path::make_floor_map(result.compiled.floor);
  result.passages =
      closed_passages(result.compiled.walls, *result.map, result.compiled.standing, body);
  return result;
}

TEST(ClosedPassages, AreNoneWhereOneWalksRoundAThing) {
  EXPECT_THAT(furnished(one_way, {thing("statue", {4, 4})}).passages, IsEmpty());
  EXPECT_THAT(furnished(one_way, {thing("statue", {7.4, 4})}).passages, IsEmpty())
      << "beside a wall, with a slit behind it";
  EXPECT_THAT(furnished(one_way, {thing("statue", {0.3, 0.3}), thing("other", {1, 0.3})}).passages,
              IsEmpty())
      << "in a corner";
  EXPECT_THAT(furnished(one_way, {thing("thin", {8.2, 1.2}, {0.3, 0.4})}).passages, IsEmpty())
      << "1 m of the door is left";
}

TEST(ClosedPassages, AreDoorsInWhichAThingStands) {
  const auto [compiled, map, passages] = furnished(one_way, {thing("statue", {8.2, 1.7})});

  ASSERT_THAT(passages, SizeIs(1));
  EXPECT_FALSE(passages[0].way_round.has_value());
  EXPECT_EQ(passages[0].by.at(0)->name, "statue");
  EXPECT_NEAR(passages[0].at.x, 8.2, 0.3);
  EXPECT_NEAR(passages[0].at.y, 1.7, 0.3);
  EXPECT_TRUE(map->has_room(passages[0].from, body));
}

TEST(ClosedPassages, NameAllThingsThatCloseThemTogether) {
  const auto passages =
      furnished(one_way, {thing("near", {7.6, 1.4}), thing("far", {7.6, 2.2})}).passages;

  ASSERT_THAT(passages, SizeIs(1));
  EXPECT_THAT(passages[0].by, SizeIs(2));
}

TEST(ClosedPassages, TellTheWayRoundWhereThereIsOne) {
  // From the south door to the north door is 5 m: round by it is less than 15 m more.
  EXPECT_THAT(furnished(two_ways, {thing("statue", {8.2, 1.7})}).passages, IsEmpty());

  constexpr const char* long_west = "[[[0, 0], [8, 0], [8, 38], [0, 38], [0, 0]]]";
  constexpr const char* long_east = "[[[8.4, 0], [16, 0], [16, 38], [8.4, 38], [8.4, 0]]]";
  constexpr const char* far_door = "[[[8, 36], [8.4, 36], [8.4, 37], [8, 37], [8, 36]]]";
  const auto passages =
      furnished(std::string(long_west) + ", " + long_east + ", " + far_door + ", " + south_door,
                {thing("statue", {8.2, 1.7})})
          .passages;

  ASSERT_THAT(passages, SizeIs(1));
  ASSERT_TRUE(passages[0].way_round.has_value());
  EXPECT_NEAR(*passages[0].way_round, 70, 3);
}

TEST(ClosedPassages, AreKnownByTheirDoorTheirRoomsOrTheirPlace) {
  const ClosedPassage passage{
      .by = {}, .at = {8.2, 1.7}, .from = {7, 1.7}, .to = {9, 1.7}, .way_round = {}};
  const std::vector<Door> doors{{.name = "gate", .a = {8.2, 1}, .b = {8.2, 2.4}}};
  std::vector<Room> rooms(2);
  rooms[0].outline = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  rooms[0].title["en"] = "West Room";
  rooms[1].outline = {{8.4, 0}, {16.4, 0}, {16.4, 8}, {8.4, 8}};
  rooms[1].id = "east";

  EXPECT_EQ(passage_name(passage, doors, rooms, "en"), "the door 'gate'");
  EXPECT_EQ(passage_name(passage, {}, rooms, "en"), "the way between 'West Room' and 'east'");
  EXPECT_EQ(passage_name(passage, {}, {}, "en"), "the passage at [8.20, 1.70]");
}

TEST(InTheWay, IsTheNearestThingThatLeavesABodyNoRoom) {
  std::vector<Standing> things{thing("far", {3, 3}), thing("near", {4, 3}),
                               thing("flat", {5, 3}, {0, 0})};
  for (Standing& each : things) each.place = ExhibitPlace::OnFloor;

  EXPECT_EQ(in_the_way(things, {4.5, 3}, body)->name, "near");
  EXPECT_EQ(in_the_way(things, {4.6, 3}, body), nullptr);
  EXPECT_EQ(in_the_way(things, {5, 3}, body), nullptr) << "one may walk over it";
}

}  // namespace
}  // namespace docent::compile::check_footprints_test
