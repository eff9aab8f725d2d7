#include "content/compile/compile_connections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "platform/sqlite/content_reader.h"
#include "tests/support/house_folder.h"

namespace docent::compile::compile_connections_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Museum compiled(const test::HouseFolder& house) {
  const test::ProgramRun run = house.compile();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return sqlite::load_museum(house.database()).value_or(Museum{});
}

std::string complaint(const test::HouseFolder& house) {
  return house.compile().err;
}

TEST(Connections, HaveOrdinaryTimesAndLengthsWhereStaffSayNone) {
  const Museum museum = compiled(test::HouseFolder());

  ASSERT_EQ(museum.connections.size(), 2U);
  const Connection &stairs = museum.connections[0], &lift = museum.connections[1];
  EXPECT_DOUBLE_EQ(stairs.metres_per_floor, 10) << "five metres up at 30 degrees";
  EXPECT_DOUBLE_EQ(stairs.seconds_per_floor, 20);
  EXPECT_FALSE(stairs.step_free);
  EXPECT_DOUBLE_EQ(stairs.stops[0].placement.heading, std::numbers::pi);
  EXPECT_DOUBLE_EQ(lift.metres_per_floor, 0);
  EXPECT_DOUBLE_EQ(lift.wait_seconds, 25);
  EXPECT_TRUE(lift.step_free);
  EXPECT_EQ(lift.stops[0].floor, 0U) << "the lowest first, whichever is written first";
}

TEST(Connections, HaveWhatStaffSay) {
  test::HouseFolder house;
  house.replace("museum.toml", "kind = \"lift\"",
                "kind = \"ramp\"\nslope = 0.1\ndirection = \"down\"\nstep_free = false\n"
                "wait_seconds = 3");

  const Connection ramp = compiled(house).connections[1];

  EXPECT_NEAR(ramp.metres_per_floor, std::hypot(5, 50), 1e-9);
  EXPECT_EQ(ramp.direction, ConnectionDirection::Down);
  EXPECT_FALSE(ramp.step_free);
  EXPECT_DOUBLE_EQ(ramp.wait_seconds, 3);
}

TEST(Floors, HaveOrdinalsTitlesAndShortNames) {
  const Museum museum = compiled(test::HouseFolder());

  EXPECT_EQ(museum.floors[0].plan.short_name, "G");
  EXPECT_EQ(museum.floors[0].title.at("en"), "Ground floor");
  EXPECT_EQ(museum.floors[1].plan.ordinal, 1);
  EXPECT_EQ(museum.floors[1].plan.short_name, "1");
  EXPECT_DOUBLE_EQ(museum.floors[1].plan.height, 5);
}

TEST(Connections, AreEnteredWhereAVisitorCanStand) {
  test::HouseFolder house;
  house.replace("museum.toml", "position = [1, 4], facing", "position = [0.1, 4], facing");

  EXPECT_THAT(complaint(house),
              AllOf(HasSubstr("error[connection-outside-floor]"), HasSubstr("'stairs'"),
                    HasSubstr("0.10 m from a wall"), Not(HasSubstr("exhibit-unreachable"))));
}

TEST(Connections, StopOnceAFloorAndOnTwoAtLeast) {
  test::HouseFolder twice;
  twice.replace("museum.toml", "{floor = \"ground\", position = [11",
                "{floor = \"upper\", position = [11");
  EXPECT_THAT(complaint(twice), HasSubstr("connection 'lift' stops twice on floor 'upper'"));

  test::HouseFolder once;
  once.replace("museum.toml", ", {floor = \"ground\", position = [11, 4]}", "");
  EXPECT_THAT(complaint(once), HasSubstr("connection 'lift' has 1 stop"));
}

TEST(Connections, AreOfAKindAndLeadToFloorsThatThereAre) {
  test::HouseFolder kind;
  kind.replace("museum.toml", "kind = \"lift\"", "kind = \"elevator\"");
  EXPECT_THAT(complaint(kind), HasSubstr("write \"stairs\" or \"escalator\" or \"lift\""));

  test::HouseFolder floor;
  floor.replace("museum.toml", "{floor = \"upper\", position = [11",
                "{floor = \"attic\", position = [11");
  EXPECT_THAT(complaint(floor), HasSubstr("there is no floor 'attic'"));

  test::HouseFolder stops;
  stops.replace("museum.toml", "{floor = \"upper\", position = [11",
                "{level = \"upper\", position = [11");
  EXPECT_THAT(complaint(stops), AllOf(HasSubstr("an item of 'stops' has no 'level'"),
                                      HasSubstr("an item of 'stops' lacks 'floor'")));
}

TEST(AnExhibit, OnAFloorThatNothingLeadsToIsAnError) {
  test::HouseFolder house;
  house.replace(
      "museum.toml", "[[connection]]\nid = \"stairs\"",
      "[[floor]]\nname = \"attic\"\nplan = \"hall.geojson\"\n[[connection]]\nid = \"stairs\"");
  house.replace("exhibits/hall.toml", "floor = \"upper\"", "floor = \"attic\"");

  EXPECT_THAT(complaint(house),
              AllOf(HasSubstr("error[exhibit-unreachable]"),
                    HasSubstr("from the kiosk to exhibit 'sword' on floor 'attic'"),
                    HasSubstr("no connection leads to 'attic'")));
}

TEST(AnExhibit, BehindAClosedLiftIsNone) {
  test::HouseFolder house;
  house.replace("museum.toml", "kind = \"lift\"", "kind = \"lift\"\nclosed = true");
  house.replace("museum.toml", "kind = \"stairs\"", "kind = \"stairs\"\nclosed = true");

  EXPECT_EQ(house.compile().exit_code, 0);
}

}  // namespace
}  // namespace docent::compile::compile_connections_test
