#include "runtime/plan/order_tours.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/runtime/path/floors.h"

namespace docent::plan::order_tours_test {
namespace {

/// A hall of 12 by 8 m with three exhibits in a row, from west to east, all on one tour.
Museum hall_with_a_tour() {
  Museum museum;
  museum.floors.push_back(test::floor_of(test::drawn(test::rectangle({0, 0}, {12, 8})), {0, 0.25}));
  for (const double x : {2.0, 5.0, 9.0}) {
    Exhibit exhibit;
    exhibit.viewing_point.position = {x, 4};
    exhibit.looking_seconds = 10;
    museum.exhibits.push_back(exhibit);
  }
  Tour tour;
  tour.title = {{"en", "All of it"}};
  tour.exhibits = {0, 1, 2};
  tour.arrives = {1, 2, 3};
  museum.tours.push_back(tour);
  museum.kiosk.position = {11, 4};
  return museum;
}

TEST(TheTours, OfAKioskInTheEastGoWest) {
  Museum museum = hall_with_a_tour();

  order_tours(museum);

  const Tour& tour = museum.tours.front();
  EXPECT_EQ(tour.exhibits, (std::vector<std::uint32_t>{2, 1, 0}));
  EXPECT_NEAR(tour.seconds, 9 + 30, 1e-9);
  EXPECT_NEAR(tour.arrives[2], 9 + 20, 1e-9);
}

TEST(TheTours, ThatStaffHaveFixedKeepTheirOrder) {
  Museum museum = hall_with_a_tour();
  museum.tours.front().fixed = true;

  order_tours(museum);

  EXPECT_EQ(museum.tours.front().exhibits, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_NEAR(museum.tours.front().arrives[0], 9, 1e-9);
}

TEST(TheTours, ToWhichThereIsNoWayStayAsTheyAre) {
  Museum museum = hall_with_a_tour();
  museum.exhibits[1].viewing_point.position = {20, 4};

  order_tours(museum);

  EXPECT_EQ(museum.tours.front().exhibits, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(TheTours, ForWhoHasSoMuchTimeAreChosenAnew) {
  Museum museum = hall_with_a_tour();
  Tour& tour = museum.tours.front();
  tour.title = {};
  tour.exhibits = {0};
  tour.arrives = {9};
  tour.minutes = 0.5;

  order_tours(museum);

  EXPECT_EQ(tour.exhibits, (std::vector<std::uint32_t>{2, 1})) << "the one in the west is too far";
  EXPECT_NEAR(tour.seconds, 6 + 20, 1e-9);
}

}  // namespace
}  // namespace docent::plan::order_tours_test
