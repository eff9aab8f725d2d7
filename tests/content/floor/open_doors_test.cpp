#include "content/floor/open_doors.h"

#include <gtest/gtest.h>

#include "tests/content/floor/random_plan.h"

namespace docent::floor::open_doors_test {
namespace {

using test::drawn;
using test::mended;
using test::rectangle;

/// Two rooms of 4 by 4 m with a wall between them, and no door.
import::ImportedPlan two_rooms(double wall) {
  import::ImportedPlan plan = drawn(rectangle({0, 0}, {4, 4}));
  plan.polygons.push_back(drawn(rectangle({4 + wall, 0}, {8 + wall, 4})).polygons.front());
  return plan;
}

TEST(OpenDoors, JoinTwoRoomsThroughTheWallBetweenThem) {
  import::ImportedPlan plan = two_rooms(0.2);

  open_doors(plan, std::vector<Door>{{.name = "door", .a = {4.1, 1}, .b = {4.1, 2}}});

  EXPECT_EQ(plan.polygons.size(), 3U);
  EXPECT_EQ(mended(plan).ring.size(), 1U);
}

TEST(OpenDoors, ChangeNothingOnTheFloorInAnOuterWallOrWhereRoomsLieFarApart) {
  import::ImportedPlan plan = two_rooms(0.2), apart = two_rooms(1.2);

  open_doors(plan, std::vector<Door>{{.name = "on the floor", .a = {2, 1}, .b = {2, 2}}});
  open_doors(plan, std::vector<Door>{{.name = "to the outside", .a = {-0.1, 1}, .b = {-0.1, 2}}});
  open_doors(apart, std::vector<Door>{{.name = "too far", .a = {4.6, 1}, .b = {4.6, 2}}});

  EXPECT_EQ(plan.polygons.size(), 2U);
  EXPECT_EQ(apart.polygons.size(), 2U);
}

}  // namespace
}  // namespace docent::floor::open_doors_test
