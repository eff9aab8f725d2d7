#include "runtime/interface/tour_walk.h"

#include <gmock/gmock.h>

#include "runtime/interface/control.h"
#include "runtime/interface/phrases.h"
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
    EXPECT_LE(touches_to(museum_, from, 8, "tour:three-rivers").size(), 2U);
  EXPECT_TRUE(is_control_name(museum_, "tour:three-rivers"));
  EXPECT_TRUE(is_control_name(museum_, "next"));
  EXPECT_TRUE(is_control_name(museum_, "skip"));
  EXPECT_FALSE(is_control_name(museum_, "tour:half-price"));
}

class ATourByTime : public testing::Test {
 protected:
  Museum museum_ = test::sample_museum_without_walls();
};

TEST_F(ATourByTime, IsOneTouchAwayFromTheWelcomeAndAtMostThreeFromElsewhere) {
  InterfaceState walking = after({}, {Action::Kind::Choose, 5});
  EXPECT_EQ(touches_to(museum_, {}, 8, "tour:minutes-30").size(), 1U);
  for (const InterfaceState& from : {walking, arrived_at(walking)})
    EXPECT_EQ(touches_to(museum_, from, 8, "tour:minutes-30").size(), 3U);
  InterfaceState card = after({}, {Action::Kind::ShowExhibits});
  card.glass = Glass::Busy;
  card.seat = 1;
  card.look = 0;
  EXPECT_EQ(touches_to(museum_, card, 8, "tour:minutes-30").size(), 2U);
}

TEST_F(ATourByTime, IsCalledByItsMinutesInEveryLanguage) {
  const Control control = control_named(museum_, {}, "tour:minutes-30");

  EXPECT_EQ(control.label.at("en"), "30 minutes");
  EXPECT_EQ(control.label.at("zh"), "30分钟");
  EXPECT_EQ(control.label.at("ar"), "٣٠ دقيقة");
  EXPECT_EQ(minutes_in(museum_, 2, 5), "٥ دقائق");
  EXPECT_EQ(minutes_in(museum_, 2, 5, Digits::Plain), "5 دقائق");
}

TEST_F(ATourByTime, IsOnTheWelcomeOnlyWhereThereIsRoom) {
  const auto offers = [&](std::uint32_t rows) {
    return std::ranges::count_if(controls_of(museum_, {}, rows), [](const Control& control) {
      return control.role != Role::Spot && (control.action.kind == Action::Kind::Choose ||
                                            control.action.kind == Action::Kind::FollowTour);
    });
  };

  EXPECT_EQ(offers(4), 0);
  EXPECT_EQ(offers(5), 6) << "three exhibits, and three tours";
}

TEST_F(ATourByTime, IsListedApartFromThoseOfStaff) {
  InterfaceState state = after({}, {Action::Kind::Begin});
  EXPECT_EQ(control_named(museum_, state, "tour:minutes-15").name, "");
  state = after_pressing(museum_, state, "times");
  EXPECT_EQ(control_named(museum_, state, "tour:three-rivers").name, "");
  state = after_pressing(museum_, state, "tour:minutes-15");
  EXPECT_EQ(state.screen, Screen::Walking);
  EXPECT_EQ(title_in(museum_, 0, museum_.tours[state.tour->tour]), "15 minutes");
}

TEST_F(ATourByTime, IsNowhereInAMuseumThatHasNone) {
  std::erase_if(museum_.tours, is_for_time);
  const InterfaceState state = after({}, {Action::Kind::Begin});

  EXPECT_EQ(control_named(museum_, state, "times").name, "");
  EXPECT_FALSE(is_control_name(museum_, "times"));
}

TEST_F(ATourByTime, HighlightsAreWhatWeighsMostOfWhatHasAPicture) {
  for (Exhibit& exhibit : museum_.exhibits) exhibit.weight = 1;
  museum_.exhibits[7].weight = 3;
  museum_.exhibits[4].weight = 2;
  museum_.exhibits[9].weight = 9;
  museum_.exhibits[9].image = 1000;  // of it there is none
  std::vector<std::uint32_t> shown;
  for (const Control& control : controls_of(museum_, {}, 8))
    if (control.role == Role::ListItem) shown.push_back(control.action.argument);

  EXPECT_EQ(shown, (std::vector<std::uint32_t>{7, 4, 0}));
}

}  // namespace
}  // namespace docent::interface::tour_walk_test
