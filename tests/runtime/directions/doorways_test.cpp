#include "runtime/directions/doorways.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "tests/runtime/directions/raster.h"
#include "tests/runtime/directions/some_ways.h"

namespace docent::directions::doorways_test {
namespace {

Vec2 point_at(std::span<const Vec2> way, double metres) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double length = glm::distance(way[i - 1], way[i]);
    if (metres <= length) return glm::mix(way[i - 1], way[i], length > 0 ? metres / length : 0);
    metres -= length;
  }
  return way.back();
}

/// The points, a few centimetres exactly, at which a way leaves rooms near their doors in a raster.
std::vector<Vec2> exits_by_doors(const test::Raster& raster, const path::Leg& leg) {
  std::vector<Vec2> exits;
  constexpr double step = 0.05;
  double length = 0;
  for (std::size_t i = 1; i < leg.points.size(); ++i)
    length += glm::distance(leg.points[i - 1], leg.points[i]);
  std::uint32_t before = none;
  for (double metres = 0; metres < length; metres += step) {
    const Vec2 at = point_at(leg.points, metres);
    const std::uint32_t room = raster.room_at(at);
    const std::uint32_t left = std::exchange(before, room);
    if (left == none || left == room) continue;
    for (const test::WaterDoor& door : raster.doors_of(left))
      if (door.width < Doorway::widest_door - 0.4 &&
          glm::distance(door.middle, at) < door.width / 2)
        exits.push_back(at);
  }
  return exits;
}

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

/// Where ways leave a room of the raster by a door of it.
TEST(DoorsAlongAWay, AreThoseThatItGoesThroughInItsOrder) {
  const test::SampleHouse& house = test::sample_house();
  std::vector<test::Raster> rasters;
  for (std::uint32_t floor = 0; floor < house.museum.floors.size(); ++floor)
    rasters.emplace_back(house.museum, floor);
  std::mt19937 random(18);
  int left = 0, passed = 0;
  for (int i = 0; i < 200; ++i) {
    const test::SomeWay some = test::some_way(random);
    for (const path::Leg& leg : some.way.legs) {
      const auto doors = doors_along(house.museum, house.doorways, leg.floor, leg.points);
      EXPECT_TRUE(std::ranges::is_sorted(doors, {}, &PassedDoor::along));
      for (const PassedDoor& door : doors) {
        const Vec2 there = point_at(leg.points, door.along);
        EXPECT_LE(glm::distance(there, door.middle), door.width / 2 + 0.01);
        const Vec2 walked = point_at(leg.points, door.along + 0.05) - there;
        EXPECT_GE(dot(walked, door.through), -1e-9);
      }
      passed += static_cast<int>(doors.size());
      for (const Vec2 exit : exits_by_doors(rasters[leg.floor], leg)) {
        ++left;
        EXPECT_TRUE(std::ranges::any_of(doors,
                                        [&](const PassedDoor& door) {
                                          return glm::distance(door.middle, exit) <
                                                 door.width / 2 + 1.2;
                                        }))
            << exit.x << ", " << exit.y;
      }
    }
  }
  EXPECT_GT(left, 100);
  EXPECT_LE(passed, 2 * left) << "the two sides of a wall are one door";
}

TEST(DoorsAlongAWay, AreNoneWithoutRooms) {
  const test::SampleHouse& house = test::sample_house();
  const std::vector<Vec2> way{{0, 0}, {30, 20}};
  EXPECT_TRUE(doors_along(house.museum, Doorways{}, 0, way).empty());
  EXPECT_TRUE(doors_along(house.museum, house.doorways, 0, {}).empty());
}

}  // namespace
}  // namespace docent::directions::doorways_test
