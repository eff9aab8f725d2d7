#include "content/compile/narrow_doors.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "content/compile/compile_floor.h"
#include "tests/support/temporary_folder.h"

namespace docent::compile::narrow_doors_test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr double radius = 0.4;

/// A rectangle of floor, from its south-west corner to its north-east one.
struct Area {
  Vec2 low{}, high{};
};

/// A floor of rooms and doorways, which become one where they meet.
CompiledFloor floor_of(const std::vector<Area>& areas) {
  std::string polygons;
  for (const auto& [low, high] : areas)
    polygons += fmt::format("{0}[[[{1}, {2}], [{3}, {2}], [{3}, {4}], [{1}, {4}], [{1}, {2}]]]",
                            polygons.empty() ? "" : ", ", low.x, low.y, high.x, high.y);
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "floor.geojson").string();
  std::ofstream(file) << R"({"type": "MultiPolygon", "coordinates": [)" << polygons << "]}";
  Report report;
  Progress progress(Progress::Output::Nothing);
  plan_floor_stages(progress);
  const std::vector<double> radii{0, radius};
  return compile_floor("floor", std::span(&file, 1), import::Coordinates::Metres, radii, report,
                       progress);
}

Room room(const std::string& title, const Area& area) {
  return {.id = title,
          .title = {{"en", title}},
          .label = (area.low + area.high) * 0.5,
          .outline = {area.low, {area.high.x, area.low.y}, area.high, {area.low.x, area.high.y}}};
}

const Area west{{0, 0}, {4, 4}}, hall{{4.4, 0}, {8.4, 4}}, east{{8.8, 0}, {12.8, 4}};
const Area door_to_hall{{4, 1.7}, {4.4, 2.32}}, door_to_east{{8.4, 1}, {8.8, 1.7}};
const std::vector<Room> rooms{room("West Room", west), room("Hall", hall), room("East Room", east)};

/// The doors that keep a body of 0.8 m that comes from the middle of the western room.
std::vector<NarrowDoor> doors_of(const std::vector<Area>& areas,
                                 const std::vector<Room>& with_rooms = rooms,
                                 const std::vector<Vec2>& wanted = {},
                                 const std::vector<Door>& named = {}) {
  const CompiledFloor compiled = floor_of(areas);
  const auto map = path::make_floor_map(compiled.floor);
  return narrow_doors({.map = *map,
                       .rooms = with_rooms,
                       .doors = named,
                       .language = "en",
                       .from = {2, 2},
                       .radius = radius},
                      wanted);
}

std::vector<std::string> names_of(const std::vector<NarrowDoor>& doors) {
  std::vector<std::string> names;
  for (const NarrowDoor& door : doors) names.push_back(door.name);
  return names;
}

TEST(NarrowDoors, AreNotThoseThatABodyTouchesOnBothSides) {
  for (const double narrower : {0.0, 1e-9, 1.9e-9}) {
    const Area door{{4, 1.7}, {4.4, 1.7 + 2 * radius - narrower}};
    EXPECT_THAT(doors_of({west, hall, door}), IsEmpty()) << narrower;
  }
  const Area narrow{{4, 1.7}, {4.4, 1.7 + 2 * radius - 1e-8}};
  EXPECT_EQ(doors_of({west, hall, narrow}).size(), 1U);
}

TEST(NarrowDoors, AreNamedByTheRoomsThatTheyJoinAndMeasured) {
  const auto doors = doors_of({west, hall, door_to_hall});

  ASSERT_EQ(doors.size(), 1U);
  EXPECT_EQ(doors[0].name, "the door between 'West Room' and 'Hall'");
  EXPECT_THAT(doors[0].width, DoubleNear(0.62, 1e-6));
  EXPECT_LE(glm::distance(doors[0].position, Vec2(4.2, 2.01)), 0.21);
}

TEST(NarrowDoors, AreNamedOneAfterAnother) {
  EXPECT_THAT(names_of(doors_of({west, hall, east, door_to_hall, door_to_east})),
              UnorderedElementsAre("the door between 'West Room' and 'Hall'",
                                   "the door between 'Hall' and 'East Room'"));
}

TEST(NarrowDoors, AreNamedSideBySide) {
  const Area second{{4, 3}, {4.4, 3.5}};

  const auto doors = doors_of({west, hall, door_to_hall, second});

  ASSERT_EQ(doors.size(), 2U);
  EXPECT_THAT(doors[0].width + doors[1].width, DoubleNear(0.62 + 0.5, 1e-6));
  for (const NarrowDoor& door : doors) EXPECT_EQ(door.is_on_widest_way, door.width > 0.6);
}

TEST(NarrowDoors, AreNamedAsStaffDoWhereTheyCanBeClosed) {
  const Door gate{.name = "night gate", .a = {4.2, 1.7}, .b = {4.2, 2.32}};

  EXPECT_THAT(names_of(doors_of({west, hall, door_to_hall}, rooms, {}, {gate})),
              ElementsAre("the door 'night gate'"));
}

TEST(NarrowDoors, AreNamedByRoomsThatHaveALabelAndNoOutline) {
  std::vector<Room> unlined{rooms[0], rooms[1]};
  for (Room& room : unlined) room.outline.clear();

  EXPECT_THAT(names_of(doors_of({west, hall, door_to_hall}, unlined)),
              ElementsAre("the door between 'West Room' and 'Hall'"));
}

TEST(NarrowDoors, AreKnownByTheirPlaceWhereNoRoomHasAName) {
  const auto doors = doors_of({west, hall, door_to_hall}, {}, {{6, 2}});

  ASSERT_EQ(doors.size(), 1U);
  EXPECT_THAT(doors[0].name, testing::MatchesRegex("the narrow place at \\[4\\.[0-9]+, 2\\.01\\]"));
}

TEST(NarrowDoors, AreOfNoInterestBesideADoorWithRoom) {
  const Area wide{{4, 2.9}, {4.4, 3.9}};

  EXPECT_THAT(doors_of({west, hall, door_to_hall, wide}), IsEmpty());
}

TEST(NarrowDoors, AreOfNoInterestWhereNobodyWantsToGo) {
  const Area store{{0, 4.4}, {1.8, 8}}, door_to_store{{1, 4}, {1.5, 4.4}};
  const Area cellar{{2.2, 4.4}, {4, 8}}, door_to_cellar{{3, 4}, {3.5, 4.4}};
  const Area between_them{{1.8, 6}, {2.2, 6.6}};

  EXPECT_THAT(doors_of({west, store, door_to_store}, {rooms[0]}), IsEmpty());
  EXPECT_THAT(
      doors_of({west, store, door_to_store, cellar, door_to_cellar, between_them}, {rooms[0]}),
      IsEmpty());
  EXPECT_THAT(names_of(doors_of({west, hall, door_to_hall, store, door_to_store})),
              ElementsAre("the door between 'West Room' and 'Hall'"));
}

TEST(NarrowDoors, MatterWhereTheyPartARoomFromAnExhibitInIt) {
  const Area gap{{4, 1}, {4.4, 1.7}};
  const Area both{west.low, hall.high};

  EXPECT_THAT(names_of(doors_of({west, hall, gap}, {room("Long Room", both)}, {{6, 2}})),
              ElementsAre(testing::StartsWith("the narrow place in 'Long Room' at [4.")));
}

TEST(NarrowDoors, AreNotPlacesInARoomThatAWiderWayLeadsRound) {
  const Area narrow{{4, 1}, {4.4, 1.6}}, wider{{4, 2.5}, {4.4, 3.2}};
  const Area both{west.low, hall.high};

  const auto doors = doors_of({west, hall, narrow, wider}, {room("Long Room", both)}, {{6, 2}});

  ASSERT_EQ(doors.size(), 1U);
  EXPECT_THAT(doors[0].width, DoubleNear(0.7, 1e-6));
}

TEST(NarrowDoors, DoNotIncludeWallsWithoutADoor) {
  EXPECT_THAT(doors_of({west, hall}, rooms, {{6, 2}}), IsEmpty());
}

}  // namespace
}  // namespace docent::compile::narrow_doors_test
