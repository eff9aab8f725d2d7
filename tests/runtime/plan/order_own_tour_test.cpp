#include "runtime/plan/order_own_tour.h"

#include <gmock/gmock.h>

#include <memory>

#include "runtime/path/building/museum_tour.h"
#include "tests/runtime/path/floors.h"

namespace docent::plan::order_own_tour_test {
namespace {

using interface::InterfaceState;
using interface::TourWalk;
using testing::ElementsAre;

/// A hall of 12 by 8 m with five exhibits in a row, from west to east; the kiosk is in the east.
class AHall : public testing::Test {
 protected:
  AHall() {
    museum_.floors.push_back(
        test::floor_of(test::drawn(test::rectangle({0, 0}, {12, 8})), {0, 0.25}));
    for (const double x : {1.0, 3.0, 5.0, 7.0, 9.0}) {
      Exhibit exhibit;
      exhibit.viewing_point.position = {x, 4};
      exhibit.looking_seconds = 10;
      museum_.exhibits.push_back(exhibit);
    }
    museum_.kiosk.position = {11, 4};
  }
  void order() {
    const path::BuildingMap building(museum_, {path::make_floor_map(museum_.floors[0])});
    order_own_tour(museum_, building, state_);
  }
  void collect(std::initializer_list<std::uint32_t> exhibits) {
    for (const std::uint32_t i : exhibits) add_to(state_.own_tour, i);
  }

  Museum museum_;
  InterfaceState state_;
};

TEST_F(AHall, IsWalkedThroughFromTheKioskOn) {
  collect({0, 4, 2, 1, 3});

  order();

  EXPECT_TRUE(state_.own_tour.is_ordered);
  EXPECT_THAT(state_.own_tour.exhibits(), ElementsAre(4, 3, 2, 1, 0));
  EXPECT_NEAR(state_.own_tour.seconds, 10 + 50, 1e-9) << "10 m at a metre a second";
  EXPECT_NEAR(state_.own_tour.arrives[4], 10 + 40, 1e-9);
}

TEST_F(AHall, KeepsWhatIsSeenAndGoneToWhenSomethingIsAddedOnTheWay) {
  collect({4, 1, 0});
  order();
  state_.tour = TourWalk{TourWalk::own, 1};  // on the way to exhibit 1
  collect({3});

  order();

  EXPECT_THAT(state_.own_tour.exhibits(), ElementsAre(4, 1, 0, 3));
  EXPECT_NEAR(state_.own_tour.seconds, 2 + 6 + 2 + 6 + 40, 1e-9);
}

TEST_F(AHall, StaysInOrderWhereThereIsNoWay) {
  museum_.exhibits[2].viewing_point.position = {20, 4};
  collect({0, 2, 4});

  order();

  EXPECT_TRUE(state_.own_tour.is_ordered);
  EXPECT_THAT(state_.own_tour.exhibits(), ElementsAre(0, 2, 4));
  EXPECT_EQ(state_.own_tour.seconds, 0);
}

}  // namespace
}  // namespace docent::plan::order_own_tour_test
