#include "runtime/interface/own_tour.h"

#include <gmock/gmock.h>

#include "runtime/interface/control.h"
#include "tests/support/sample_museum.h"

namespace docent::interface::own_tour_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(OwnTour, HoldsWhatIsAddedOnceAndUpToSixty) {
  OwnTour tour;
  for (std::uint32_t i = 0; i < 100; ++i) add_to(tour, i % 70);

  EXPECT_EQ(tour.count, OwnTour::most);
  EXPECT_TRUE(tour.is_full());
  EXPECT_FALSE(tour.is_ordered);
  EXPECT_EQ(place_in(tour, 59), 59U);
  EXPECT_EQ(place_in(tour, 60), tour.count);
}

TEST(OwnTour, IsAsIfNothingHadEverBeenInItOnceAllIsTakenOut) {
  OwnTour tour;
  for (const std::uint32_t i : {3U, 5U, 8U}) add_to(tour, i);

  take_from(tour, 5);
  EXPECT_THAT(tour.exhibits(), ElementsAre(3, 8));
  take_from(tour, 7);
  take_from(tour, 3);
  take_from(tour, 8);

  EXPECT_EQ(tour, OwnTour{});
}

/// A visitor who has collected some exhibits and looks at the list of them.
class AVisitorWithATour : public testing::Test {
 protected:
  AVisitorWithATour() {
    state_ = after(state_, {Action::Kind::Begin});
    for (const std::uint32_t i : {4U, 9U, 2U}) state_ = after(state_, {Action::Kind::Collect, i});
    state_.own_tour.is_ordered = true;  // as the worker has said
    press("own-tour");
  }
  const Control* find(const std::string& name) {
    controls_ = controls_of(museum_, state_, 30);
    const auto found = std::ranges::find_if(
        controls_, [&](const Control& c) { return c.name == name && c.role != Role::Spot; });
    return found == controls_.end() ? nullptr : &*found;
  }
  void press(const std::string& name) {
    const Control* control = find(name);
    ASSERT_NE(control, nullptr) << name;
    ASSERT_TRUE(control->enabled) << name;
    state_ = after(state_, control->action);
  }

  Museum museum_ = test::sample_museum_without_walls();
  InterfaceState state_;
  std::vector<Control> controls_;
};

TEST_F(AVisitorWithATour, SeesItsStopsAndWalksThemOneAfterTheOther) {
  EXPECT_EQ(state_.lists, Listed::OwnTour);
  press("start-tour");
  EXPECT_EQ(state_.exhibit, 4U);
  EXPECT_EQ(state_.screen, Screen::Walking);
  press("skip");
  EXPECT_EQ(state_.exhibit, 9U);
  state_.arrived = true;
  state_.screen = Screen::Arrived;
  press("next");
  EXPECT_EQ(state_.exhibit, 2U);
  EXPECT_EQ(find("skip"), nullptr) << "that is the last";
}

TEST_F(AVisitorWithATour, TakesOutWhatTheyDoNotWantAndFindsTheExhibitsAgain) {
  const auto name = [&](std::uint32_t exhibit) {
    return "collect:" + museum_.exhibits[exhibit].id;
  };
  press(name(9));
  EXPECT_THAT(state_.own_tour.exhibits(), ElementsAre(4, 2));
  press(name(4));
  press(name(2));

  EXPECT_EQ(state_.lists, Listed::Exhibits) << "nothing is left to list";
  EXPECT_EQ(find("own-tour"), nullptr);
}

TEST_F(AVisitorWithATour, GoesOnAtTheSameStopWhenOneBeforeItIsTakenOut) {
  press("start-tour");
  press("skip");

  state_ = after(state_, {Action::Kind::Discard, 4});
  EXPECT_EQ(state_.tour, (TourWalk{TourWalk::own, 0}));
  state_ = after(state_, {Action::Kind::Discard, 9});

  EXPECT_FALSE(state_.tour) << "they go there, on no tour";
  EXPECT_EQ(state_.exhibit, 9U);
}

TEST_F(AVisitorWithATour, LeavesNothingToTheNext) {
  EXPECT_THAT(after(state_, {Action::Kind::Home}).own_tour.exhibits(), IsEmpty());
}

TEST_F(AVisitorWithATour, HasItOrderedAnewForWaysWithoutSteps) {
  EXPECT_FALSE(after(state_, {Action::Kind::AvoidSteps, 1}).own_tour.is_ordered);
}

TEST_F(AVisitorWithATour, CanAddNothingToAFullOne) {
  while (!state_.own_tour.is_full()) add_to(state_.own_tour, 1000U + state_.own_tour.count);
  state_ = after(state_, {Action::Kind::ShowExhibits});

  ASSERT_NE(find("collect:" + museum_.exhibits[0].id), nullptr);
  EXPECT_FALSE(find("collect:" + museum_.exhibits[0].id)->enabled);
  EXPECT_TRUE(find("collect:" + museum_.exhibits[4].id)->enabled) << "but take out";
}

}  // namespace
}  // namespace docent::interface::own_tour_test
