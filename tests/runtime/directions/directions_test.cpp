#include "runtime/directions/directions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/runtime/directions/raster.h"
#include "tests/runtime/directions/some_ways.h"

namespace docent::directions::directions_test {
namespace {

constexpr double in_degrees = 180 / std::numbers::pi;

std::vector<test::Raster> rasters() {
  std::vector<test::Raster> made;
  for (std::uint32_t floor = 0; floor < test::sample_house().museum.floors.size(); ++floor)
    made.emplace_back(test::sample_house().museum, floor);
  return made;
}

std::string told(const std::vector<DoorStep>& steps) {
  std::string text;
  for (const DoorStep& step : steps)
    text += test::sample_house().museum.rooms[step.from].id + " side " +
            std::to_string(static_cast<int>(step.side)) + " " + std::to_string(step.nth) + "/" +
            std::to_string(step.of) + " ";
  return text;
}

TEST(Directions, HoldOnThePlan) {
  const test::SampleHouse& house = test::sample_house();
  const std::vector<test::Raster> raster = rasters();
  std::mt19937 random(20261125);
  int borderline = 0;
  for (int n = 0; n < 1000; ++n) {
    const test::SomeWay some = test::some_way(random);
    const auto facts = direct(house.museum, house.doorways, some.start, some.way, some.goal);
    ASSERT_TRUE(facts);
    EXPECT_NEAR(facts->metres, some.way.length, 1e-9);
    double degrees = some.start.heading * in_degrees;
    std::size_t part = 0;
    for (const path::Leg& leg : some.way.legs) {
      if (!leg.is_along_floor()) {
        const Connection& connection = house.museum.connections[leg.connection];
        ASSERT_TRUE(facts->parts[part - 1].then);
        EXPECT_EQ(facts->parts[part - 1].then->kind, connection.kind);
        EXPECT_EQ(facts->parts[part - 1].then->floor, leg.to_floor);
        EXPECT_EQ(facts->parts[part - 1].then->up, house.museum.floors[leg.to_floor].plan.height >
                                                       house.museum.floors[leg.floor].plan.height);
        EXPECT_TRUE(connection.step_free || !facts->step_free);
        for (const ConnectionStop& stop : connection.stops)
          if (stop.floor == leg.to_floor) degrees = stop.placement.heading * in_degrees + 180;
        continue;
      }
      const test::Raster::Told expected = raster[leg.floor].tell(leg.points, degrees);
      if (expected.is_borderline) {
        ++borderline;
        ++part;
        continue;
      }
      EXPECT_EQ(facts->parts[part].room, expected.first_room);
      EXPECT_EQ(facts->parts[part].doors, expected.steps)
          << "from " << some.start.position.x << ", " << some.start.position.y << " looking to "
          << some.start.heading * in_degrees << "\n  said " << told(facts->parts[part].doors)
          << "\n  is   " << told(expected.steps);
      ++part;
    }
    EXPECT_EQ(part, facts->parts.size());
  }
  EXPECT_LT(borderline, 100);
}

/// The whole of a floor of 20 by 20 metres without rooms.
TEST(Directions, TellTurnsWhereNoRoomsAreKnown) {
  Museum museum;
  museum.floors.emplace_back();
  path::BuildingWay way;
  way.status = path::BuildingStatus::Ok;
  way.legs = {{.floor = 0, .to_floor = 0, .points = {{0, 0}, {0, 10}, {8, 10}, {8, 18}}}};
  const auto facts = direct(museum, {}, {{0, 0}, std::numbers::pi / 2}, way, {.position = {9, 18}});
  ASSERT_TRUE(facts);
  const auto& turns = facts->parts.at(0).turns;
  ASSERT_EQ(turns.size(), 2U);
  EXPECT_EQ(turns[0].side, Side::Right);
  EXPECT_NEAR(turns[0].after, 10, 1);
  EXPECT_EQ(turns[1].side, Side::Left);
  EXPECT_NEAR(turns[1].after, 8, 1);
}

/// Two rooms of 4 by 4 metres, 6 apart, and what lies between them has no name: many drawings have
/// passages without one.
class RoomsAndAPassage : public ::testing::Test {
 protected:
  RoomsAndAPassage() {
    museum_.floors.emplace_back();
    for (const double west : {0.0, 10.0}) {
      Room room{.id = "", .title = {}, .label = {}, .outline = {}};
      room.outline = {{west, 0}, {west + 4, 0}, {west + 4, 4}, {west, 4}};
      museum_.rooms.push_back(std::move(room));
    }
  }
  FloorPart part_of(Vec2 from, Vec2 to) const {
    path::BuildingWay way;
    way.status = path::BuildingStatus::Ok;
    way.legs = {{.floor = 0, .to_floor = 0, .points = {from, to}}};
    return direct(museum_, {}, {from, 0}, way, {.position = to}).value().parts.at(0);
  }

 private:
  Museum museum_;
};

TEST_F(RoomsAndAPassage, TellWhenOneSetsOutOutsideOfTheGoalsRoom) {
  const FloorPart part = part_of({6, 2}, {12, 2});

  EXPECT_EQ(part.room, none) << "and not in the goal's room";
  ASSERT_EQ(part.doors.size(), 1U);
  EXPECT_EQ(part.doors[0], (DoorStep{.from = none, .to = 1}));
}

TEST_F(RoomsAndAPassage, TellThePassageBetweenThem) {
  const FloorPart part = part_of({2, 2}, {12, 2});

  EXPECT_EQ(part.room, 0U);
  ASSERT_EQ(part.doors.size(), 2U);
  EXPECT_EQ(part.doors[0].to, none);
  EXPECT_EQ(part.doors[1], (DoorStep{.from = none, .to = 1}));
}

TEST_F(RoomsAndAPassage, TellWhenTheGoalIsInThePassage) {
  const FloorPart part = part_of({2, 2}, {8, 2});

  EXPECT_EQ(part.room, 0U);
  EXPECT_EQ(part.last_room(), none);
}

TEST_F(RoomsAndAPassage, OfWhichNoStepIsTakenAreTheRightRoomAlready) {
  const FloorPart part = part_of({1, 2}, {3, 2});

  EXPECT_EQ(part.room, 0U);
  EXPECT_TRUE(part.doors.empty());
}

TEST(Directions, AreNoneWhereThereIsNoWay) {
  const test::SampleHouse& house = test::sample_house();
  EXPECT_FALSE(direct(house.museum, house.doorways, {}, {}, {}));
}

}  // namespace
}  // namespace docent::directions::directions_test
