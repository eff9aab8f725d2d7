#include "runtime/directions/doorways.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/runtime/directions/raster.h"
#include "tests/runtime/directions/some_ways.h"

namespace docent::directions::doorways_test {
namespace {

TEST(Doorways, AreWhereWaterRunsOutOfARoom) {
  const test::SampleHouse& house = test::sample_house();
  for (std::uint32_t floor = 0; floor < house.museum.floors.size(); ++floor) {
    const test::Raster raster(house.museum, floor);
    for (std::uint32_t room = 0; room < house.museum.rooms.size(); ++room) {
      if (house.museum.rooms[room].floor != floor) continue;
      const auto found = house.doorways.of(room);
      const auto& water = raster.doors_of(room);
      EXPECT_EQ(found.size(), water.size()) << house.museum.rooms[room].id;
      for (const test::WaterDoor& door : water)
        EXPECT_TRUE(std::ranges::any_of(found,
                                        [&](const Doorway& doorway) {
                                          return glm::distance(doorway.middle, door.middle) < 0.3 &&
                                                 std::abs(doorway.width - door.width) < 0.4;
                                        }))
            << house.museum.rooms[room].id << " at " << door.middle.x << ", " << door.middle.y;
    }
  }
}

TEST(Doorways, LeadToTheRoomBeyond) {
  const test::SampleHouse& house = test::sample_house();
  const auto room = [&](std::string_view id) {
    return static_cast<std::uint32_t>(std::ranges::find(house.museum.rooms, id, &Room::id) -
                                      house.museum.rooms.begin());
  };
  const auto doors = house.doorways.of(room("foyer"));
  EXPECT_TRUE(std::ranges::any_of(
      doors, [&](const Doorway& door) { return door.beyond == room("court"); }));
  EXPECT_TRUE(std::ranges::any_of(
      doors, [&](const Doorway& door) { return door.beyond == room("stair-hall"); }));
}

TEST(Doorways, AreNoneOfARoomWithoutAnOutline) {
  Museum museum = test::sample_house().museum;
  museum.rooms[0].outline.clear();
  const Doorways doorways = find_doorways(museum, test::sample_house().maps);
  EXPECT_TRUE(doorways.of(0).empty());
  EXPECT_TRUE(doorways.of(static_cast<std::uint32_t>(museum.rooms.size())).empty());
}

}  // namespace
}  // namespace docent::directions::doorways_test
