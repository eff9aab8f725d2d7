#include "runtime/interface/control.h"

#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <set>

#include "runtime/interface/face.h"
#include "runtime/interface/pictures.h"
#include "tests/runtime/interface/any_request.h"
#include "tests/support/sample_museum.h"

namespace docent::interface::control_test {
namespace {

using testing::ElementsAre;

std::vector<std::string> names(const std::vector<Control>& controls) {
  std::vector<std::string> out;
  out.reserve(controls.size());
  for (const Control& control : controls) out.push_back(control.name);
  return out;
}

TEST(ControlGraph, ReachesAnExhibitOfTheFirstPageFromTheWelcomeByTwoTouches) {
  const Museum museum = test::sample_museum_without_walls();

  const auto touches = touches_to(museum, {}, 8, "exhibit:" + museum.exhibits[3].id);

  EXPECT_THAT(names(touches), ElementsAre("begin", "exhibit:" + museum.exhibits[3].id));
  EXPECT_EQ(touches.back().role, Role::ListItem);
}

TEST(ControlGraph, TurnsPagesToAnExhibitFurtherOn) {
  const Museum museum = test::sample_museum_without_walls();

  const auto touches = touches_to(museum, {}, 8, "exhibit:" + museum.exhibits[9].id);

  EXPECT_THAT(names(touches),
              ElementsAre("begin", "page:next", "exhibit:" + museum.exhibits[9].id));
}

TEST(ControlGraph, TouchesTheModelWhereThePageIsTooFarOn) {
  const Museum museum = test::sample_museum_without_walls();

  const auto touches = touches_to(museum, {}, 8, "exhibit:" + museum.exhibits.back().id);

  EXPECT_THAT(names(touches), ElementsAre("exhibit:" + museum.exhibits.back().id));
  EXPECT_EQ(touches.back().role, Role::Spot);
}

/// The sample museum with a floor above, which has the last exhibit.
Museum museum_of_two_floors() {
  Museum museum = test::sample_museum_without_walls();
  museum.floors.resize(2);
  museum.floors[0].plan.name = "ground";
  museum.floors[1].plan.name = "upper";
  museum.floors[1].plan.short_name = "1";
  museum.floors[1].plan.ordinal = 1;
  for (Exhibit& exhibit : museum.exhibits) exhibit.floor = 0;
  museum.exhibits.back().floor = 1;
  return museum;
}

TEST(ControlGraph, OffersTheFloorsTheHighestFirst) {
  const Museum museum = museum_of_two_floors();
  InterfaceState state;
  state.screen = Screen::Choosing;

  std::vector<std::string> floors;
  for (const Control& control : controls_of(museum, state, 8))
    if (control.name.starts_with("floor:")) floors.push_back(control.name);

  EXPECT_THAT(floors, ElementsAre("floor:upper", "floor:ground"));
  for (const Control& control : controls_of(test::sample_museum_without_walls(), state, 8))
    EXPECT_FALSE(control.name.starts_with("floor:")) << "a house of one floor";
}

TEST(ControlGraph, ShowsOnTheModelWhatIsOnItsFloor) {
  const Museum museum = museum_of_two_floors();
  InterfaceState state;
  state.screen = Screen::Choosing;
  for (const std::uint32_t floor : {0U, 1U}) {
    state.floor = floor;
    for (const Control& control : controls_of(museum, state, 8)) {
      if (control.role != Role::Spot) continue;
      EXPECT_EQ(museum.exhibits[control.action.argument].floor, floor) << control.name;
    }
  }
}

TEST(ControlGraph, ChoosesAnotherFloorWhereAnExhibitIsToBeTouchedOnTheModel) {
  const Museum museum = museum_of_two_floors();

  const auto touches = touches_to(museum, {}, 8, "exhibit:" + museum.exhibits.back().id);

  EXPECT_THAT(names(touches),
              ElementsAre("begin", "floor:upper", "exhibit:" + museum.exhibits.back().id));
}

TEST(ControlGraph, ReturnsToTheKiosksFloorWithTheNextVisitor) {
  InterfaceState state;
  state.screen = Screen::Choosing;
  state = after(state, {Action::Kind::ShowFloor, 1});
  ASSERT_EQ(state.floor, 1U);

  EXPECT_FALSE(after(state, {Action::Kind::Home}).floor);
  EXPECT_FALSE(after(state, {Action::Kind::Return}).floor);
}

TEST(ControlGraph, ReachesEveryNamedControlWithinThreeTouchesFromEveryScreen) {
  const Museum museum = test::sample_museum_without_walls();
  std::vector<std::string> wanted{"home",        "stop",           "choose",
                                  "begin",       "route:shortest", "route:offset",
                                  "language:zh", "route:skeleton"};
  for (const Exhibit& exhibit : museum.exhibits) wanted.push_back("exhibit:" + exhibit.id);
  for (const Screen screen :
       {Screen::Welcome, Screen::Choosing, Screen::Walking, Screen::Arrived}) {
    InterfaceState state;
    state.screen = screen;
    if (screen != Screen::Welcome) state.exhibit = 0;
    state.arrived = screen == Screen::Arrived;
    for (const std::string& name : wanted) {
      const auto touches = touches_to(museum, state, 8, name);
      ASSERT_FALSE(touches.empty()) << name << " from screen " << static_cast<int>(screen);
      EXPECT_LE(touches.size(), 3U);
      EXPECT_EQ(touches.back().name, name);
    }
  }
}

TEST(ControlGraph, DoesNotSendTheGuideAwayOnTheWayToARouteKind) {
  const Museum museum = test::sample_museum_without_walls();

  EXPECT_THAT(names(touches_to(museum, {}, 8, "route:offset")),
              ElementsAre("begin", "route:offset"));
}

TEST(Places, AreListedByTheirKindsAndByTheWiderOnesThatTheyAnswer) {
  Museum museum = test::sample_museum_without_walls();
  museum.places = {{.id = "a", .kind = PlaceKind::WomensToilets},
                   {.id = "b", .kind = PlaceKind::Lift},
                   {.id = "c", .kind = PlaceKind::Lift}};
  InterfaceState state;
  state = after(state, {Action::Kind::ShowPlaces});

  std::vector<std::string> listed;
  for (const Control& control : controls_of(museum, state, 8))
    if (control.role == Role::ListItem) listed.push_back(control.name);

  EXPECT_EQ(state.screen, Screen::Choosing);
  EXPECT_THAT(listed, ElementsAre("place:toilets", "place:womens_toilets", "place:lift"));
}

TEST(Places, AreSoughtByTheirKindAndGoneToByTheirSpot) {
  const Museum museum = test::sample_museum_without_walls();
  InterfaceState state;
  state.exhibit = 3;
  state.arrived = true;
  state.tour = TourWalk{0, 1};

  const InterfaceState sought =
      after(state, {Action::Kind::Seek, static_cast<std::uint32_t>(PlaceKind::Cafe)});
  EXPECT_EQ(sought.screen, Screen::Walking);
  EXPECT_EQ(sought.seeks, PlaceKind::Cafe);
  EXPECT_FALSE(sought.exhibit || sought.place || sought.tour || sought.arrived);

  const InterfaceState gone = after(sought, {Action::Kind::GoToPlace, 2});
  EXPECT_EQ(gone.place, 2U);
  EXPECT_FALSE(gone.seeks);
  EXPECT_FALSE(after(gone, {Action::Kind::Choose, 0}).place);
  EXPECT_FALSE(after(gone, {Action::Kind::Home}).place);
}

TEST(Places, OfTheKindThatOneIsOnTheWayToDoNotTurnOneRound) {
  InterfaceState state;
  const Action toilets{Action::Kind::Seek, static_cast<std::uint32_t>(PlaceKind::Toilets)};
  state = after(state, toilets);
  state.place = 4;  // has been found

  state = after(after(state, {Action::Kind::ShowExhibits}), toilets);

  EXPECT_EQ(state.place, 4U);
  EXPECT_EQ(state.screen, Screen::Walking);
}

TEST(Places, ToiletsAreOneTouchAwayFromEveryScreenAndCard) {
  const Museum museum = test::sample_museum_without_walls();
  for (const Screen screen :
       {Screen::Welcome, Screen::Picking, Screen::Choosing, Screen::Walking, Screen::Arrived})
    for (const bool of_places : {false, true})
      for (const bool on_card : {false, true}) {
        InterfaceState state;
        state.screen = screen;
        state.lists = of_places ? Listed::Places : Listed::Exhibits;
        if (on_card) {
          if (screen == Screen::Welcome) continue;  // nobody is there
          state.glass = Glass::Busy;
          state.seat = 1;
          state.seats = 3;
        }
        EXPECT_THAT(names(touches_to(museum, state, 8, "toilets")), ElementsAre("toilets"))
            << static_cast<int>(screen);
      }
}

TEST(Places, FollowWhatIsTheScreensOwnInTheOrderOfTheKeys) {
  const Museum museum = test::sample_museum_without_walls();
  for (const Screen screen :
       {Screen::Welcome, Screen::Choosing, Screen::Walking, Screen::Arrived}) {
    InterfaceState state;
    state.screen = screen;
    state.exhibit = 1;
    const std::vector<std::string> all = names(controls_of(museum, state, 8));
    const auto toilets = std::ranges::find(all, "toilets");
    for (const std::string_view own : {"language:en", "home", "back", "choose", "begin"}) {
      const auto at = std::ranges::find(all, own);
      EXPECT_TRUE(at == all.end() || at < toilets) << own;
    }
  }
}

TEST(Places, AreFoundByTheirNamesInVisits) {
  const Museum museum = test::sample_museum_without_walls();

  EXPECT_THAT(names(touches_to(museum, {}, 8, "place:cafe")), ElementsAre("places", "place:cafe"));
  EXPECT_TRUE(is_control_name(museum, "place:shop"));
  EXPECT_TRUE(is_control_name(museum, "spot:cafe"));
  EXPECT_TRUE(is_control_name(museum, "exhibits"));
  EXPECT_FALSE(is_control_name(museum, "place:parking"));
}

/// Names of what is asked of ways in a state, in a building with these connections.
std::vector<std::string> avoidances(std::vector<Connection> connections, InterfaceState state,
                                    std::vector<WayOffer> offers = {}) {
  Museum museum = test::sample_museum_without_walls();
  museum.connections = std::move(connections);
  museum.ways = std::move(offers);
  std::vector<std::string> out;
  for (const std::string& name : names(controls_of(museum, state, 8)))
    if (name == "step-free" || name == "no-escalators") out.push_back(name);
  return out;
}

TEST(WaysWithoutSteps, AreOfferedWhereAWayIsChosenAndThereAreSteps) {
  const Connection lift{.id = "lift", .kind = ConnectionKind::Lift, .step_free = true, .stops = {}};
  const Connection stairs{.id = "stairs", .stops = {}};
  const Connection escalator{.id = "up", .kind = ConnectionKind::Escalator, .stops = {}};
  InterfaceState state;
  for (const Screen screen : {Screen::Choosing, Screen::Walking}) {
    state.screen = screen;
    EXPECT_THAT(avoidances({lift}, state), ElementsAre());
    EXPECT_THAT(avoidances({lift, stairs}, state), ElementsAre("step-free"));
    EXPECT_THAT(avoidances({lift, escalator}, state), ElementsAre("step-free", "no-escalators"));
    EXPECT_THAT(avoidances({lift, escalator}, state, {{WayChoice::StepFree, {}}}),
                ElementsAre("step-free"))
        << "what the museum offers";
  }
  for (const Screen screen : {Screen::Welcome, Screen::Arrived}) {
    state.screen = screen;
    EXPECT_THAT(avoidances({stairs}, state), ElementsAre());
  }
}

TEST(WaysWithoutSteps, AreAskedForUntilTheVisitorSaysOtherwiseOrLeaves) {
  InterfaceState state;
  state.screen = Screen::Walking;
  state.exhibit = 1;
  state = after(state, {Action::Kind::AvoidSteps, 1});
  state = after(state, {Action::Kind::AvoidEscalators, 1});
  state = after(state, {Action::Kind::Choose, 2});
  EXPECT_TRUE(state.ways.step_free && state.ways.no_escalators);

  EXPECT_FALSE(after(state, {Action::Kind::AvoidSteps, 0}).ways.step_free);
  EXPECT_EQ(after(state, {Action::Kind::Home}).ways, path::Permissions{});
}

/// A museum that speaks so many languages.
Museum museum_of_languages(std::size_t count) {
  Museum museum = test::sample_museum_without_walls();
  while (museum.languages.size() < count) {
    Language more = museum.languages[0];
    more.tag = "x-" + std::to_string(museum.languages.size());
    more.name = "Language " + std::to_string(museum.languages.size());
    museum.languages.push_back(std::move(more));
  }
  return museum;
}

TEST(Languages, OfWhichThereAreTooManyForARowAreInAListAndAllOnTheWelcomeScreen) {
  const Museum museum = museum_of_languages(12);
  const auto names = [&](const InterfaceState& state) {
    std::set<std::string> found;
    for (const Control& control : controls_of(museum, state, 8)) found.insert(control.name);
    return found;
  };
  InterfaceState state;
  EXPECT_TRUE(names(state).contains("language:x-11"));

  state.screen = Screen::Walking;
  state.exhibit = 0;
  EXPECT_FALSE(names(state).contains("language:x-11"));
  ASSERT_TRUE(names(state).contains("languages"));

  state = after(state, {Action::Kind::ShowLanguages});
  EXPECT_EQ(state.screen, Screen::Choosing);
  EXPECT_TRUE(names(state).contains("language:en"));

  state = after(state, {Action::Kind::Speak, 3});
  EXPECT_EQ(state.screen, Screen::Walking) << "and the walk goes on";
  EXPECT_EQ(state.language, 3U);
}

TEST(Languages, AreChosenOnTheWayWithoutEndingIt) {
  const Museum museum = museum_of_languages(12);
  InterfaceState state;
  state.screen = Screen::Walking;
  state.exhibit = 0;

  EXPECT_THAT(names(touches_to(museum, state, 8, "language:zh")),
              ElementsAre("languages", "language:zh"));
}

TEST(Languages, AreThreeTouchesAwayFromEveryScreenHoweverMany) {
  const Museum museum = museum_of_languages(16);
  for (const Screen screen :
       {Screen::Welcome, Screen::Choosing, Screen::Walking, Screen::Arrived}) {
    InterfaceState state;
    state.screen = screen;
    if (screen == Screen::Walking || screen == Screen::Arrived) state.exhibit = 0;
    EXPECT_FALSE(touches_to(museum, state, 8, "language:x-15").empty()) << static_cast<int>(screen);
  }
}

TEST(RouteControls, OfferAFurtherKindThatIsInTheTable) {
  const Museum museum = test::sample_museum_without_walls();
  std::vector<RouteKindInfo> kinds(route_kinds.begin(), route_kinds.end());
  kinds.push_back({RouteKind{3}, "wandering", "wandering path", 0x123456, {}});

  const std::vector<Control> controls = route_controls(museum, RouteKind{3}, kinds);

  EXPECT_THAT(names(controls),
              ElementsAre("route:shortest", "route:skeleton", "route:offset", "route:wandering"));
  EXPECT_TRUE(controls.back().selected);
  EXPECT_EQ(after({}, controls.back().action).kind, RouteKind{3});
}

TEST(RouteControls, AreThoseThatTheMuseumOffersByTheNamesItGivesThem) {
  Museum museum = test::sample_museum_without_walls();
  const LocalText quiet{{museum.languages[0].tag, "Quiet way"}};
  museum.ways = {
      {WayChoice::Skeleton, quiet}, {WayChoice::StepFree, {}}, {WayChoice::Shortest, {}}};

  const std::vector<Control> controls = route_controls(museum, RouteKind::Skeleton);

  EXPECT_THAT(names(controls), ElementsAre("route:skeleton", "route:shortest"));
  EXPECT_EQ(in_language(museum, 0, controls[0].label), "Quiet way");
  EXPECT_EQ(in_language(museum, 1, controls[0].label), word(museum, 1, "route_skeleton"));
  EXPECT_EQ(in_language(museum, 0, controls[1].label), word(museum, 0, "route_shortest"));
  EXPECT_EQ(usual_kind(museum.ways), RouteKind::Skeleton);
}

TEST(RouteControls, AreNoneWhereThereIsNothingToChoose) {
  Museum museum = test::sample_museum_without_walls();
  museum.ways = {{WayChoice::Offset, {}}, {WayChoice::StepFree, {}}};
  EXPECT_THAT(route_controls(museum, RouteKind::Offset), testing::IsEmpty());
  EXPECT_EQ(usual_kind(museum.ways), RouteKind::Offset);

  museum.ways = {{WayChoice::StepFree, {}}};
  EXPECT_EQ(usual_kind(museum.ways), RouteKind::Shortest);
}

TEST(AWayThatWasChosen, IsTheUsualOneAgainForTheNextVisitor) {
  InterfaceState state;
  state.kind = state.usual_kind = RouteKind::Skeleton;

  state = after(state, {Action::Kind::TakeRoute, static_cast<std::uint32_t>(RouteKind::Offset)});
  EXPECT_EQ(state.kind, RouteKind::Offset);
  EXPECT_EQ(after(state, {Action::Kind::Home}).kind, RouteKind::Skeleton);
}

TEST(Screens, AreInTheOrderOfTheirNumbersAndHaveControlsOnAGlassAndOnACard) {
  const Museum museum = test::sample_museum_without_walls();
  for (std::size_t i = 0; i < screens.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(screens[i].screen), i);
    InterfaceState state;
    state.screen = screens[i].screen;
    state.exhibit = 0;
    EXPECT_FALSE(controls_of(museum, state, 8).empty()) << i;
    state.glass = Glass::Busy;
    state.seat = 1;
    EXPECT_FALSE(controls_of(museum, state, 4).empty()) << i;
  }
}

TEST(ControlGraph, KnowsWhichNamesExist) {
  const Museum museum = test::sample_museum_without_walls();

  EXPECT_TRUE(is_control_name(museum, "home"));
  EXPECT_TRUE(is_control_name(museum, "exhibit:" + museum.exhibits.back().id));
  EXPECT_FALSE(is_control_name(museum, "exhibit:mona-lisa"));
  EXPECT_FALSE(is_control_name(museum, ""));
}

TEST(ControlGraph, KnowsWhatLeafsAndTellsMoreWhereThereIsAnythingToSee) {
  Museum museum = test::sample_museum_without_walls();
  museum.pictures.clear();
  for (Exhibit& exhibit : museum.exhibits) exhibit.more.clear();
  for (const char* name : {"picture:next", "picture:previous", "more", "less"})
    EXPECT_FALSE(is_control_name(museum, name)) << name;
  add_pictures_and_more(museum);
  for (const char* name : {"picture:next", "picture:previous", "more", "less"})
    EXPECT_TRUE(is_control_name(museum, name)) << name;
}

TEST(ControlGraph, AVideoIsPlayedAndStoppedWhereItIsSeen) {
  Museum museum = test::sample_museum_without_walls();
  EXPECT_FALSE(is_control_name(museum, "video:play"));
  museum.images.push_back(
      {.name = "images/turning.webm", .width = 320, .height = 180, .bytes = {}});
  museum.pictures = {{.exhibit = 0, .image = static_cast<std::uint32_t>(museum.images.size() - 1)}};
  EXPECT_TRUE(is_control_name(museum, "video:play"));
  InterfaceState state;
  state.screen = Screen::Arrived;
  state.arrived = true;
  state.exhibit = 0;
  const auto press = [&](std::string_view name) {
    for (const Control& control : controls_of(museum, state, 6))
      if (control.name == name) {
        state = after(state, control.action);
        return true;
      }
    return false;
  };

  EXPECT_FALSE(press("video:play")) << "its own picture stands still";
  ASSERT_TRUE(press("picture:next"));
  EXPECT_TRUE(state.plays) << "it begins by itself";
  EXPECT_FALSE(press("video:play"));
  ASSERT_TRUE(press("video:stop"));
  EXPECT_FALSE(state.plays);
  ASSERT_TRUE(press("video:play"));
  ASSERT_TRUE(press("picture:next"));
  EXPECT_FALSE(press("video:stop"));
}

TEST(ControlGraph, ASoundIsPlayedAndStoppedAtItsExhibitAlone) {
  Museum museum = test::sample_museum_without_walls();
  museum.sounds.clear();
  EXPECT_FALSE(is_control_name(museum, "sound:1"));
  museum.sounds = {{.exhibit = 2, .title = {{"en", "A bell"}}, .description = {}}};
  EXPECT_TRUE(is_control_name(museum, "sound:1"));
  EXPECT_FALSE(is_control_name(museum, "sound:2"));
  InterfaceState state;
  state.screen = Screen::Arrived;
  state.arrived = true;
  const auto press = [&](std::string_view name) {
    for (const Control& control : controls_of(museum, state, 6))
      if (control.name == name) {
        state = after(state, control.action);
        return true;
      }
    return false;
  };

  state.exhibit = 2;
  EXPECT_FALSE(press("sound:1")) << "nothing can be heard";
  state.can_sound = true;
  ASSERT_TRUE(press("sound:1"));
  EXPECT_EQ(state.sound, 0);
  EXPECT_EQ(shown_sound(museum, state), 0U);
  ASSERT_TRUE(press("sound:1"));
  EXPECT_FALSE(state.sound);
  ASSERT_TRUE(press("sound:1"));
  ASSERT_TRUE(press("choose"));
  EXPECT_FALSE(state.sound) << "who leaves listens no more";
  state = {};
  state.can_sound = true;
  state.screen = Screen::Arrived;
  state.exhibit = 1;
  EXPECT_FALSE(press("sound:1"));
}

TEST(ControlGraph, AVideoStandsStillForWhoListens) {
  InterfaceState watching;
  watching.screen = Screen::Arrived;
  watching.plays = true;

  const InterfaceState listening = after(watching, {Action::Kind::PlaySound, 0});
  EXPECT_FALSE(listening.plays);
  EXPECT_FALSE(after(listening, {Action::Kind::PlayVideo, 1}).sound);
  EXPECT_FALSE(after(listening, {Action::Kind::ShowPicture, 1}).sound);
}

TEST(ControlGraph, AVideoDoesNotGoOnForWhoWasElsewhereMeanwhile) {
  InterfaceState watching;
  watching.screen = Screen::Arrived;
  watching.arrived = true;
  watching.exhibit = 0;
  watching.picture = 1;
  watching.plays = true;

  const InterfaceState choosing = after(watching, {Action::Kind::ShowLanguages});
  const InterfaceState back = after(choosing, {Action::Kind::Speak, 1});

  EXPECT_FALSE(choosing.plays);
  EXPECT_EQ(back.screen, Screen::Arrived);
  EXPECT_FALSE(back.plays);
  EXPECT_TRUE(after(watching, {Action::Kind::RaiseContrast, 1}).plays) << "it is still seen";
}

TEST(ControlGraph, EveryEnabledControlLeadsToAStateWithControls) {
  const Museum museum = test::sample_museum_without_walls();
  std::vector<InterfaceState> open{{}};
  std::vector<InterfaceState> seen{{}};
  std::set<std::string> met;
  while (!open.empty() && seen.size() < 5000) {
    const InterfaceState state = open.back();
    open.pop_back();
    const auto controls = controls_of(museum, state, 12);
    ASSERT_FALSE(controls.empty());
    for (const Control& control : controls) {
      met.insert(control.name);
      if (!control.enabled) continue;
      const InterfaceState next = after(state, control.action);
      ASSERT_LT(next.page, page_count(museum, next, 12));
      if (std::ranges::find(seen, next) != seen.end()) continue;
      seen.push_back(next);
      open.push_back(next);
    }
  }

  for (const Exhibit& exhibit : museum.exhibits)
    EXPECT_TRUE(met.contains("exhibit:" + exhibit.id)) << exhibit.id;
  EXPECT_TRUE(met.contains("stop"));
}

TEST(ControlGraph, NamesAreUniqueButForSpots) {
  const Museum museum = test::sample_museum_without_walls();

  EXPECT_TRUE(rc::check("no two controls of a panel share a name", [&] {
    InterfaceState state;
    state.screen =
        *rc::gen::element(Screen::Welcome, Screen::Choosing, Screen::Walking, Screen::Arrived);
    if (*rc::gen::arbitrary<bool>())
      state.exhibit = *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum.exhibits.size()));
    state.page = *rc::gen::inRange(0U, 9U);
    std::set<std::string> names;
    for (const Control& control : controls_of(museum, state, *rc::gen::inRange(1U, 30U))) {
      if (control.role == Role::Spot) continue;
      RC_ASSERT(names.insert(control.name).second);
      for (const Language& language : museum.languages)
        RC_ASSERT(!control.label.at(language.tag).empty());
    }
  }));
}

}  // namespace
}  // namespace docent::interface::control_test
