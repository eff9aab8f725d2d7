#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <cmath>
#include <set>
#include <string>

#include "runtime/guide/guide.h"
#include "runtime/guide/waiting_places.h"
#include "runtime/interface/seats.h"
#include "runtime/scene/look.h"
#include "runtime/scene/side.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::shared_glass_test {
namespace {

constexpr std::uint32_t seats = 8;

GuideSettings settings() {
  return {.shape = {.width = 1920, .height = 1080, .diagonal_inches = 55},
          .idle_reset = Seconds{120},
          .visitors = seats};
}

/// A large glass and those who stand at it, in simulated time.
class Glassful {
 public:
  Glassful()
      : planner_(test::sample_museum(), {test::boxes, {}},
                 planner_size(test::sample_museum(), settings()).avatars,
                 planner_size(test::sample_museum(), settings()).parts),
        guide_(test::sample_museum(), planner_, settings()) {
    run(0.5);
  }

  void run(double seconds) { test::run(planner_, guide_, seconds); }
  void down(std::uint32_t id, float x, float y) {
    guide_.touch({.kind = input::InputEvent::Kind::Down, .contact = {id, x, y}});
  }
  void up(std::uint32_t id, float x, float y) {
    guide_.touch({.kind = input::InputEvent::Kind::Up, .contact = {id, x, y}});
  }
  void tap(float x, float y) {
    down(1, x, y);
    run(0.05);
    up(1, x, y);
    run(0.05);
  }
  /// A control of a seat's card, or of the model where `seat` is 0; where it is.
  scene::Rect place_of(std::uint32_t seat, std::string_view name) {
    for (const interface::Control& control :
         guide_.view(seat == 0 ? 0 : guide_.part_of(seat))->controls)
      if (control.name == name && control.enabled) return control.rect;
    return {};
  }
  void tap(std::uint32_t seat, std::string_view name) {
    const scene::Rect at = place_of(seat, name);
    ASSERT_GT(at.width, 0) << name << " at seat " << seat;
    tap(at.x + at.width / 2, at.y + at.height / 2);
  }
  /// The names of the exhibits on a card's page of the list; tours come before them.
  std::vector<std::string> exhibits_at(std::uint32_t seat) {
    std::vector<std::string> names;
    for (const interface::Control& control : guide_.view(guide_.part_of(seat))->controls)
      if (control.name.starts_with("exhibit:") && control.rect.width > 0)
        names.push_back(control.name);
    return names;
  }
  /// Somebody comes to a seat and picks a guide.
  void sit_down(std::uint32_t seat, std::string_view look) {
    tap(middle_of(seat), 0.95F);
    tap(seat, "look:" + std::string(look));
  }
  static float middle_of(std::uint32_t seat) {
    return (static_cast<float>(seat) - 0.5F) / static_cast<float>(seats);
  }

  const interface::InterfaceState& at(std::uint32_t seat) {
    return guide_.state(guide_.part_of(seat));
  }
  const interface::InterfaceState& model() { return guide_.state(0); }
  Guide& guide() { return guide_; }

 private:
  plan::Planner planner_;
  Guide guide_;
};

double distance(const Agent& one, const Placement& place) {
  return glm::distance(one.avatar.body.position, place.position);
}

TEST(ASharedGlass, HasAllGuidesWaitingApartFromEachOther) {
  Glassful glass;

  EXPECT_EQ(glass.model().glass, interface::Glass::Quiet);
  ASSERT_EQ(std::ranges::count_if(glass.guide().crowd().members(), &Agent::is_here),
            static_cast<std::ptrdiff_t>(scene::guide_look_count));
  for (std::uint32_t i = 0; i < scene::guide_look_count; ++i) {
    const Agent& one = glass.guide().crowd()[i];
    EXPECT_TRUE(one.is_here);
    EXPECT_EQ(one.avatar.look, i);
    for (std::uint32_t j = 0; j < i; ++j)
      EXPECT_GT(distance(one, glass.guide().crowd()[j].avatar.body), 0.85);
  }
  glass.run(5);
  EXPECT_EQ(glass.guide().counters().collisions, 0U);
}

TEST(ASharedGlass, OpensACardForEachOfTwoWhoTouchAtTheSameTime) {
  Glassful glass;
  glass.down(1, Glassful::middle_of(3), 0.9F);
  glass.down(2, Glassful::middle_of(6), 0.9F);
  glass.up(2, Glassful::middle_of(6), 0.9F);
  glass.up(1, Glassful::middle_of(3), 0.9F);
  glass.run(0.1);

  EXPECT_EQ(glass.at(3).screen, interface::Screen::Picking);
  EXPECT_EQ(glass.at(6).screen, interface::Screen::Picking);
  EXPECT_EQ(glass.at(4).screen, interface::Screen::Welcome);
  EXPECT_EQ(glass.model().glass, interface::Glass::Busy);
}

TEST(ASharedGlass, OffersAGuideToOneVisitorOnly) {
  Glassful glass;
  glass.sit_down(2, "rose");
  glass.tap(Glassful::middle_of(5), 0.9F);

  EXPECT_EQ(glass.at(2).screen, interface::Screen::Choosing);
  EXPECT_EQ(glass.place_of(5, "look:rose").width, 0);
  EXPECT_GT(glass.place_of(5, "look:sky").width, 0);
}

TEST(ASharedGlass, GivesAGuideToTheFirstOfTwoWhoPickItInOneFrame) {
  Glassful glass;
  glass.tap(Glassful::middle_of(1), 0.9F);
  glass.tap(Glassful::middle_of(2), 0.9F);
  const scene::Rect one = glass.place_of(1, "look:navy"), two = glass.place_of(2, "look:navy");
  glass.down(1, one.x + one.width / 2, one.y + one.height / 2);
  glass.down(2, two.x + two.width / 2, two.y + two.height / 2);
  glass.up(1, one.x + one.width / 2, one.y + one.height / 2);
  glass.up(2, two.x + two.width / 2, two.y + two.height / 2);
  glass.run(0.1);

  EXPECT_EQ(glass.at(1).look, 3U);
  EXPECT_FALSE(glass.at(2).look);
  EXPECT_EQ(glass.at(2).screen, interface::Screen::Picking);
}

TEST(ASharedGlass, LeadsEightVisitorsAtOnceEachByTheirOwnGuide) {
  Glassful glass;
  for (std::uint32_t seat = 1; seat <= seats; ++seat)
    glass.sit_down(seat, scene::looks[seat - 1].name);
  for (std::uint32_t seat = 1; seat <= seats; ++seat) {
    for (std::uint32_t page = 0; page < (seat + 1) / 2; ++page) glass.tap(seat, "page:next");
    const std::vector<std::string> listed = glass.exhibits_at(seat);
    ASSERT_GE(listed.size(), 2U) << "seat " << seat;
    glass.tap(seat, listed[seat % 2]);
  }
  glass.run(4);

  std::set<std::uint32_t> colours;
  for (const scene::RibbonDraw& ribbon : glass.guide().draw_list().ribbons)
    colours.insert(ribbon.look.value());
  EXPECT_EQ(colours.size(), seats);
  glass.run(70);
  for (std::uint32_t seat = 1; seat <= seats; ++seat) {
    const interface::InterfaceState& state = glass.at(seat);
    ASSERT_TRUE(state.exhibit);
    EXPECT_TRUE(state.arrived) << "seat " << seat;
    EXPECT_LT(distance(glass.guide().crowd()[seat - 1],
                       test::sample_museum().exhibits[*state.exhibit].viewing_point),
              1.1)
        << "it stands beside the place from which one looks";
  }
  EXPECT_EQ(glass.guide().counters().collisions, 0U);
  EXPECT_EQ(glass.guide().counters().routes, seats);
}

/// The spot on the model that is furthest to one side.
const interface::Control& outermost_spot(Glassful& glass, bool left) {
  const auto& controls = glass.guide().view(0)->controls;
  const auto at = [](const interface::Control& c) {
    const bool is_exhibit = c.action.kind == interface::Action::Kind::Choose;
    return is_exhibit && c.rect.width > 0 ? c.rect.x : 0.5F;
  };
  return left ? *std::ranges::min_element(controls, {}, at)
              : *std::ranges::max_element(controls, {}, at);
}

TEST(ASharedGlass, TakesATouchOnTheModelAsThatOfTheNearestVisitor) {
  Glassful glass;
  glass.sit_down(2, "rose");
  glass.sit_down(7, "sky");
  glass.run(2);
  const interface::Control left = outermost_spot(glass, true), right = outermost_spot(glass, false);
  glass.down(1, right.rect.x + right.rect.width / 2, right.rect.y + right.rect.height / 2);
  glass.down(2, left.rect.x + left.rect.width / 2, left.rect.y + left.rect.height / 2);
  glass.up(1, right.rect.x + right.rect.width / 2, right.rect.y + right.rect.height / 2);
  glass.up(2, left.rect.x + left.rect.width / 2, left.rect.y + left.rect.height / 2);
  glass.run(0.2);

  EXPECT_EQ(glass.at(2).exhibit, left.action.argument);
  EXPECT_EQ(glass.at(7).exhibit, right.action.argument);
}

TEST(ASharedGlass, LetsWhoeverTouchesAnExhibitAwayFromAllOthersPickAGuideWhoSetsOutAtOnce) {
  Glassful glass;
  glass.sit_down(1, "teal");
  glass.run(2);
  const interface::Control spot = outermost_spot(glass, false);
  glass.tap(spot.rect.x + spot.rect.width / 2, spot.rect.y + spot.rect.height / 2);

  EXPECT_EQ(glass.at(1).screen, interface::Screen::Choosing);
  const interface::InterfaceState& other = glass.guide().state(glass.guide().part_of({}));
  EXPECT_GT(other.seat, 4U);
  EXPECT_EQ(other.screen, interface::Screen::Picking);
  EXPECT_EQ(other.exhibit, spot.action.argument);
  const std::uint32_t seat = *other.seat;
  glass.tap(seat, "look:sky");
  glass.run(2);
  EXPECT_EQ(glass.at(seat).screen, interface::Screen::Walking);
  EXPECT_EQ(glass.at(seat).exhibit, spot.action.argument);
  EXPECT_TRUE(glass.guide().crowd()[4].goal.has_value());
}

TEST(ASharedGlass, IsReachedUpwardsByWhoStandsBeforeIt) {
  Glassful glass;
  glass.sit_down(4, "rose");
  glass.tap(Glassful::middle_of(4), 0.02F);

  EXPECT_EQ(glass.model().glass, interface::Glass::Busy);
  for (std::uint32_t seat = 1; seat <= seats; ++seat)  // whatever is marked up there, it is theirs
    EXPECT_EQ(glass.at(seat).screen == interface::Screen::Welcome, seat != 4);
}

TEST(ASharedGlass, HoldsAPressWhileOthersComeAndGo) {
  Glassful glass;
  glass.tap(Glassful::middle_of(3), 0.9F);
  const scene::Rect sky = glass.place_of(3, "look:sky");
  glass.down(9, sky.x + sky.width / 2, sky.y + sky.height / 2);
  glass.sit_down(1, "teal");
  glass.up(9, sky.x + sky.width / 2, sky.y + sky.height / 2);
  glass.run(0.1);

  EXPECT_EQ(glass.at(3).look, 4U);
}

TEST(ASharedGlass, DoesNotTakeASecondTapOnLeaveForANewVisitor) {
  Glassful glass;
  glass.sit_down(2, "rose");
  const scene::Rect leave = glass.place_of(2, "home");
  for (int tap = 0; tap < 2; ++tap)
    glass.tap(leave.x + leave.width / 2, leave.y + leave.height / 2);
  glass.run(0.5);
  EXPECT_EQ(glass.at(2).screen, interface::Screen::Welcome);

  glass.tap(Glassful::middle_of(2), 0.9F);
  EXPECT_EQ(glass.at(2).screen, interface::Screen::Picking);
}

TEST(ASharedGlass, CallsAGuideBackWhoHasNotYetSetOut) {
  Glassful glass;
  glass.sit_down(3, "saffron");
  const Placement home = glass.guide().crowd()[2].avatar.body;
  const scene::Rect row = glass.place_of(3, "exhibit:" + test::sample_museum().exhibits[0].id);
  const scene::Rect leave = glass.place_of(3, "home");
  glass.down(1, row.x + row.width / 2, row.y + row.height / 2);
  glass.down(2, leave.x + leave.width / 2, leave.y + leave.height / 2);
  glass.up(1, row.x + row.width / 2, row.y + row.height / 2);
  glass.up(2, leave.x + leave.width / 2, leave.y + leave.height / 2);
  glass.run(15);

  EXPECT_LT(distance(glass.guide().crowd()[2], home), 0.1);
}

TEST(ASharedGlass, IsFreedOfJitterAtRest) {
  Glassful glass;
  glass.sit_down(5, "rose");
  glass.down(1, Glassful::middle_of(5), 0.6F);
  for (int i = 0; i < 150; ++i) {
    glass.guide().touch(
        {.kind = input::InputEvent::Kind::Move,
         .contact = {1, Glassful::middle_of(5) + 0.0005F * static_cast<float>(i % 2), 0.6F}});
    glass.run(1);
  }
  EXPECT_TRUE(glass.guide().is_vacant());
}

TEST(ASharedGlass, LetsTheCardFollowAVisitorWhoGoesOnAlongIt) {
  Glassful glass;
  glass.sit_down(1, "plum");
  for (const float x : {0.15F, 0.25F, 0.35F, 0.4F, 0.4F}) glass.tap(x, 0.5F);
  glass.run(1);

  const interface::InterfaceState& state = glass.guide().state(glass.guide().part_of({}));
  EXPECT_EQ(state.look, 7U);
  EXPECT_GE(state.seat, 3U);
  EXPECT_EQ(glass.at(1).screen, interface::Screen::Welcome);
  EXPECT_EQ(glass.guide().part_of(state.seat), glass.guide().part_of({}));
}

TEST(ASharedGlass, TellsANinthVisitorKindlyAndForAWhileOnly) {
  Glassful glass;
  for (std::uint32_t seat = 1; seat <= seats; ++seat)
    glass.sit_down(seat, scene::looks[seat - 1].name);
  EXPECT_EQ(glass.model().glass, interface::Glass::Full);

  glass.tap(0.02F, 0.02F);
  EXPECT_EQ(glass.model().glass, interface::Glass::TurnedAway);
  glass.run(9);
  EXPECT_EQ(glass.model().glass, interface::Glass::Full);

  glass.tap(4, "home");
  EXPECT_EQ(glass.model().glass, interface::Glass::Busy);
  EXPECT_GT(glass.place_of(4, "begin").width, 0);
}

TEST(ASharedGlass, SendsAGuideHomeWhenItsVisitorLeavesAndLendsItToTheNext) {
  Glassful glass;
  glass.sit_down(3, "saffron");
  const Placement home = glass.guide().crowd()[2].avatar.body;
  while (glass.exhibits_at(3).empty()) glass.tap(3, "page:next");  // tours come first
  glass.tap(3, "exhibit:" + test::sample_museum().exhibits[0].id);
  glass.run(8);
  EXPECT_GT(distance(glass.guide().crowd()[2], home), 0.5);
  glass.tap(3, "stop");
  glass.tap(3, "home");
  glass.run(0.2);

  EXPECT_EQ(glass.at(3).screen, interface::Screen::Welcome);
  EXPECT_EQ(glass.model().glass, interface::Glass::Quiet);
  glass.run(20);
  EXPECT_LT(distance(glass.guide().crowd()[2], home), 0.1);
  glass.sit_down(8, "saffron");
  EXPECT_EQ(glass.at(8).look, 2U);
}

TEST(ASharedGlass, FreesASeatWhoseVisitorHasGone) {
  Glassful glass;
  glass.tap(Glassful::middle_of(4), 0.9F);
  glass.sit_down(6, "sky");
  glass.run(21);  // undecided for so long
  EXPECT_EQ(glass.at(4).screen, interface::Screen::Welcome);
  EXPECT_EQ(glass.at(6).screen, interface::Screen::Choosing);
  glass.run(102);
  EXPECT_TRUE(glass.guide().is_vacant());
}

TEST(ASharedGlass, LeadsEachVisitorAlongATourOfTheirOwn) {
  Glassful glass;
  glass.sit_down(2, "navy");
  glass.sit_down(6, "sky");
  const auto collect_one = [&] {
    while (glass.exhibits_at(2).empty()) glass.tap(2, "page:next");
    const std::string exhibit = glass.exhibits_at(2).back();
    glass.tap(2, "collect:" + exhibit.substr(exhibit.find(':') + 1));
  };
  collect_one();
  glass.tap(2, "page:next");
  collect_one();
  EXPECT_EQ(glass.at(2).own_tour.count, 2);
  EXPECT_EQ(glass.at(6).own_tour.count, 0) << "of the other visitor";

  while (glass.at(2).page > 0) glass.tap(2, "page:previous");
  glass.tap(2, "own-tour");
  glass.run(0.5);  // until it is in order
  glass.tap(2, "start-tour");

  EXPECT_EQ(glass.at(2).screen, interface::Screen::Walking);
  ASSERT_TRUE(glass.at(2).tour);
  EXPECT_EQ(glass.at(2).tour->tour, interface::TourWalk::own);
  EXPECT_EQ(glass.at(6).screen, interface::Screen::Choosing);
}

TEST(ASharedGlass, SpeaksToEachVisitorInTheirLanguage) {
  Glassful glass;
  glass.tap(Glassful::middle_of(2), 0.9F);
  glass.tap(2, "language:ar");
  glass.sit_down(5, "ivory");

  EXPECT_EQ(glass.at(2).language, 2U);
  EXPECT_EQ(glass.at(5).language, 0U);
}

TEST(ASharedGlass, StaysSoundWhateverHandsDoOnIt) {
  EXPECT_TRUE(rc::check("one guide each, one seat each", [] {
    Glassful glass;
    for (int i = *rc::gen::inRange(20, 120); i > 0; --i) {
      const auto id = *rc::gen::inRange(0U, 14U);
      const float x = static_cast<float>(*rc::gen::inRange(0, 1001)) / 1000;
      const float y = static_cast<float>(*rc::gen::inRange(0, 1001)) / 1000;
      if (*rc::gen::arbitrary<bool>()) {
        glass.down(id, x, y);
        glass.run(1.0 / 60);
      }
      glass.up(id, x, y);
      glass.run(*rc::gen::element(0.0, 0.05, 0.5));
    }
    std::set<std::uint32_t> seen, picked;
    int there = 0, picking = 0;
    for (std::uint32_t seat = 1; seat <= seats; ++seat) {
      const interface::InterfaceState& state = glass.at(seat);
      seen.insert(*state.seat);
      if (state.screen != interface::Screen::Welcome) ++there;
      if (state.screen == interface::Screen::Picking) ++picking;
      if (state.look) picked.insert(*state.look);
    }
    RC_ASSERT(seen.size() == seats);
    RC_ASSERT(static_cast<int>(picked.size()) == there - picking);
    RC_ASSERT((glass.model().glass == interface::Glass::Quiet) == (there == 0));
  }));
}

TEST(WaitingPlaces, HaveAWallBehindThemAndTheKioskInSight) {
  const auto map =
      path::make_floor_map(test::sample_museum().floors[test::sample_museum().kiosk_floor]);
  const auto places =
      waiting_places(*map, test::sample_museum().kiosk, 8, test::sample_museum().body_radius, {});

  ASSERT_EQ(places.size(), 8U);
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Placement& place = places[i];
    EXPECT_GT(path::clearance_at(*map, place.position), test::sample_museum().body_radius);
    EXPECT_TRUE(path::can_see(*map, place.position, test::sample_museum().kiosk.position));
    const Vec2 ahead = 0.3 * Vec2{std::cos(place.heading), std::sin(place.heading)};
    EXPECT_GT(path::clearance_at(*map, place.position + ahead),
              path::clearance_at(*map, place.position - ahead));
  }
}

TEST(WaitingPlaces, KeepClearOfWhereOthersWantToStand) {
  const auto map =
      path::make_floor_map(test::sample_museum().floors[test::sample_museum().kiosk_floor]);
  const auto places =
      waiting_places(*map, test::sample_museum().kiosk, 8, test::sample_museum().body_radius, {});
  const Vec2 wanted = places[3].position;
  for (const Placement& place :
       waiting_places(*map, test::sample_museum().kiosk, 8, test::sample_museum().body_radius,
                      std::span(&wanted, 1)))
    EXPECT_GT(glm::distance(place.position, wanted), 0.85);
}

TEST(Seats, AreAtLeastAHandWideAndLeaveTheModelMostOfTheGlass) {
  EXPECT_TRUE(rc::check("any glass", [] {
    interface::ScreenShape shape;
    shape.width = *rc::gen::inRange(720U, 7681U);
    shape.height = *rc::gen::inRange(720U, 4321U);
    shape.diagonal_inches = static_cast<float>(*rc::gen::inRange(10, 121));
    shape.sides.bits = static_cast<std::uint8_t>(*rc::gen::inRange(1, 16));
    const std::uint32_t n = interface::seats_on(shape, *rc::gen::inRange(0U, 20U));
    RC_ASSERT(n >= 1 && n <= interface::most_seats);
    const scene::Rect model = interface::model_of(shape);
    RC_ASSERT(model.width * model.height >= 0.55F);
    for (std::uint32_t i = 1; n > 1 && i <= n; ++i) {
      const scene::Rect card = interface::card_of(shape, n, i),
                        column = interface::column_of(shape, n, i);
      const float mm = interface::measures_of(shape).mm;
      const bool is_at_end = scene::is_at_end(interface::side_of(shape, n, i));
      RC_ASSERT(column.width * static_cast<float>(is_at_end ? shape.height : shape.width) >=
                100 * mm - 1);
      RC_ASSERT(card.x >= column.x - 1e-3F);
      RC_ASSERT(card.x + card.width <= column.x + column.width + 1e-3F);
    }
  }));
}

TEST(ATable, HasItsNamesAndNumbersTurnedToThoseWhoAreThere) {
  GuideSettings lying = settings();
  lying.shape.sides.add(scene::Side::Bottom);
  lying.shape.sides.add(scene::Side::Top);
  plan::Planner planner(test::sample_museum(), {test::boxes, {}},
                        planner_size(test::sample_museum(), lying).avatars,
                        planner_size(test::sample_museum(), lying).parts);
  Guide guide(test::sample_museum(), planner, lying);
  const auto sides = [&] {
    test::run(planner, guide, 1);
    static_cast<void>(guide.draw_list());
    std::set<scene::Side> all;
    for (const interface::FloorLabel& label : guide.view(0)->labels)
      if (label.anchor_x >= 0) all.insert(label.side);
    return all;
  };

  EXPECT_EQ(sides(), (std::set{scene::Side::Bottom, scene::Side::Top})) << "whoever may come";
  const interface::View& card = *guide.view(guide.part_of(1));
  ASSERT_EQ(card.side, scene::Side::Bottom);
  const scene::Rect join = card.controls.front().rect;
  for (const auto kind : {input::InputEvent::Kind::Down, input::InputEvent::Kind::Up}) {
    guide.touch({.kind = kind, .contact = {1, join.x + join.width / 2, join.y + join.height / 2}});
    test::run(planner, guide, 0.1);
  }
  EXPECT_EQ(sides(), std::set{scene::Side::Bottom}) << "somebody is there";
}

}  // namespace
}  // namespace docent::guide::shared_glass_test
