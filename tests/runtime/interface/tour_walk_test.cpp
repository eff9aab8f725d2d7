#include "runtime/interface/tour_walk.h"

#include <gmock/gmock.h>

#include "runtime/interface/control.h"
#include "tests/support/sample_museum.h"

namespace docent::interface::tour_walk_test {
namespace {

constexpr std::uint32_t last = 6;

Control control_named(const Museum& museum, const InterfaceState& state, const std::string& name) {
  for (const Control& control : controls_of(museum, state, 30))
    if (control.name == name && control.role != Role::Spot) return control;
  return {};
}
/// After pressing a control that is there.
InterfaceState after_pressing(const Museum& museum, const InterfaceState& state,
                              const std::string& name) {
  const Control control = control_named(museum, state, name);
  EXPECT_EQ(control.name, name);
  return after(state, control.action);
}
InterfaceState arrived_at(InterfaceState state) {
  state.arrived = true;
  state.screen = Screen::Arrived;
  return state;
}

class ATourOnTheGlass : public testing::Test {
 protected:
  ATourOnTheGlass() {
    state_ = after(state_, {Action::Kind::Begin});
    state_ = after_pressing(museum_, state_, "tour:three-rivers");
  }
  const Tour& tour() const { return museum_.tours.front(); }

  Museum museum_ = test::sample_museum_without_walls();
  InterfaceState state_;
};

TEST_F(ATourOnTheGlass, BeginsWithTheWayToItsFirstExhibit) {
  EXPECT_EQ(state_.screen, Screen::Walking);
  EXPECT_EQ(state_.exhibit, tour().exhibits.front());
  EXPECT_EQ(state_.tour, (TourWalk{0, 0}));
}

TEST_F(ATourOnTheGlass, GoesOnToTheNextExhibitWhenTheVisitorSaysSo) {
  state_ = after_pressing(museum_, arrived_at(state_), "next");

  EXPECT_EQ(state_.screen, Screen::Walking);
  EXPECT_FALSE(state_.arrived);
  EXPECT_EQ(state_.exhibit, tour().exhibits[1]);
  EXPECT_EQ(state_.tour, (TourWalk{0, 1}));
}

TEST_F(ATourOnTheGlass, SkipsTheExhibitThatItIsOnTheWayTo) {
  state_ = after_pressing(museum_, state_, "skip");

  EXPECT_EQ(state_.exhibit, tour().exhibits[1]);
}

TEST_F(ATourOnTheGlass, OffersNothingFurtherAtItsEnd) {
  state_.tour = TourWalk{0, last};
  state_.exhibit = tour().exhibits[last];

  EXPECT_EQ(control_named(museum_, state_, "skip").name, "");
  EXPECT_EQ(control_named(museum_, arrived_at(state_), "next").name, "");
}

TEST_F(ATourOnTheGlass, VisitsEveryExhibitOnce) {
  std::vector<std::uint32_t> seen{*state_.exhibit};
  for (std::uint32_t stop = 0; stop < last; ++stop) {
    state_ = after_pressing(museum_, arrived_at(state_), "next");
    seen.push_back(*state_.exhibit);
  }

  EXPECT_EQ(seen, tour().exhibits);
}

TEST_F(ATourOnTheGlass, EndsWhenTheVisitorGoesElsewhere) {
  EXPECT_FALSE(after(state_, {Action::Kind::Choose, 5}).tour.has_value());
  EXPECT_FALSE(after(state_, {Action::Kind::Stop}).tour.has_value());
  EXPECT_FALSE(after(state_, {Action::Kind::Home}).tour.has_value());
  EXPECT_EQ(after(after(state_, {Action::Kind::ShowExhibits}), {Action::Kind::Return}).tour,
            state_.tour)
      << "who only looks at the list is still on it";
}

TEST_F(ATourOnTheGlass, SaysHowLongItStillTakes) {
  const double look = museum_.exhibits[tour().exhibits.front()].looking_seconds;

  EXPECT_DOUBLE_EQ(seconds_left(museum_, {}, TourWalk{0, 0}, false), 700);
  EXPECT_DOUBLE_EQ(seconds_left(museum_, {}, TourWalk{0, 0}, true), 660);
  EXPECT_DOUBLE_EQ(seconds_left(museum_, {}, TourWalk{0, 1}, false), 660 - look);
  EXPECT_DOUBLE_EQ(seconds_left(museum_, {}, TourWalk{0, last}, true), 60);
  EXPECT_DOUBLE_EQ(seconds_left(museum_, {}, TourWalk{9, 0}, true), 0) << "there is no such tour";
}

TEST_F(ATourOnTheGlass, IsThreeTouchesAwayAtMost) {
  for (const InterfaceState& from : {InterfaceState{}, state_, arrived_at(state_)})
    EXPECT_LE(touches_to(museum_, from, 8, "tour:quarter-hour").size(), 2U);
  EXPECT_TRUE(is_control_name(museum_, "tour:quarter-hour"));
  EXPECT_TRUE(is_control_name(museum_, "next"));
  EXPECT_TRUE(is_control_name(museum_, "skip"));
  EXPECT_FALSE(is_control_name(museum_, "tour:half-price"));
}

}  // namespace
}  // namespace docent::interface::tour_walk_test
