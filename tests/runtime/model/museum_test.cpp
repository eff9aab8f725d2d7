#include "runtime/model/museum.h"

#include <gtest/gtest.h>

namespace docent::museum_test {
namespace {

Museum of_three_kiosks() {
  Museum museum;
  museum.kiosk = {{1, 1}, 0.5};
  museum.kiosks = {{.id = "foyer", .floor = 0, .placement = {{1, 1}, 0.5}},
                   {.id = "cafe", .floor = 0, .placement = {{9, 4}, -1.5}},
                   {.id = "tower", .floor = 2, .placement = {{3, 3}, 0}}};
  museum.ambient.count = 5;
  return museum;
}

TEST(AKioskOfSeveral, StandsWhereTheMuseumSaysThatItDoes) {
  Museum museum = of_three_kiosks();

  EXPECT_TRUE(stand_at(museum, "cafe"));
  EXPECT_EQ(museum.kiosk.position, Vec2(9, 4));
  EXPECT_EQ(museum.kiosk_floor, 0U);
  EXPECT_EQ(museum.ambient.count, 5U);
}

TEST(AKioskOfSeveral, OnAnotherFloorIsQuiet) {
  Museum museum = of_three_kiosks();

  EXPECT_TRUE(stand_at(museum, "tower"));
  EXPECT_EQ(museum.kiosk_floor, 2U);
  EXPECT_EQ(museum.ambient.count, 0U);
}

TEST(AKioskOfSeveral, ThatTheMuseumDoesNotHaveChangesNothing) {
  Museum museum = of_three_kiosks();

  EXPECT_FALSE(stand_at(museum, "roof"));
  EXPECT_EQ(museum.kiosk.position, Vec2(1, 1));
  Museum of_one;
  EXPECT_FALSE(stand_at(of_one, ""));
}

}  // namespace
}  // namespace docent::museum_test
