#include "runtime/guide/guide.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "runtime/scene/theme.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::guide_test {
namespace {

/// A guide in simulated time: the worker's answers are there in the next step.
class Session {
 public:
  explicit Session(const Museum& shown = test::sample_museum())
      : planner_(shown, {test::boxes, {}}), guide_(shown, planner_, settings()) {
    run(0.1);
  }

  void run(double seconds) { test::run(planner_, guide_, seconds); }
  void tap(std::string_view name, interface::Role role = interface::Role::ListItem) {
    const auto& controls = guide_.view()->controls;
    const auto found = std::ranges::find_if(controls, [&](const interface::Control& c) {
      return c.name == name && (c.role != interface::Role::Spot) == (role != interface::Role::Spot);
    });
    ASSERT_NE(found, controls.end()) << name;
    const float x = found->rect.x + found->rect.width / 2;
    const float y = found->rect.y + found->rect.height / 2;
    touch(input::InputEvent::Kind::Down, 1, x, y);
    run(0.05);
    touch(input::InputEvent::Kind::Up, 1, x, y);
    run(0.05);
  }
  void touch(input::InputEvent::Kind kind, std::uint32_t id, float x, float y) {
    guide_.touch({.kind = kind, .contact = {id, x, y}});
  }
  void key(input::Key key) {
    guide_.touch({.kind = input::InputEvent::Kind::KeyDown, .contact = {}, .key = key});
  }
  void close(const Closures& closures) {
    planner_.close(closures);
    guide_.heed_closures();
  }
  Guide& guide() { return guide_; }

 private:
  static GuideSettings settings() {
    return {.shape = {.width = 1920, .height = 1080}, .idle_reset = Seconds{20}};
  }
  plan::Planner planner_;
  Guide guide_;
};

std::string first_exhibit() {
  return "exhibit:" + test::sample_museum().exhibits.front().id;
}

std::size_t rings(Session& session) {
  return static_cast<std::size_t>(std::ranges::count(session.guide().draw_list().quads,
                                                     scene::QuadFill::Ring, &scene::Quad::fill));
}

TEST(Guide, WelcomesFirst) {
  Session session;

  EXPECT_EQ(session.guide().state(), interface::InterfaceState{});
  ASSERT_NE(session.guide().view(), nullptr);
  EXPECT_FALSE(session.guide().draw_list().quads.empty());
  EXPECT_EQ(session.guide().draw_list().avatars.size(), 1U);
}

/// Metres that the way's pattern moves in a second, whatever it is wrapped at.
float flow_in_a_second(Session& session) {
  session.tap(first_exhibit());
  session.run(1);
  const auto& ribbons = session.guide().draw_list().ribbons;
  if (ribbons.empty()) return 0;
  const float before = ribbons.front().flow;
  session.run(1);
  const float moved = session.guide().draw_list().ribbons.front().flow - before;
  return moved < 0 ? moved + 7.2F : moved;
}

TEST(Guide, ShowsItsWayFlowAsFastAfterAMonthAsOnTheFirstDay) {
  Session young, old;
  // A month of nights: nobody comes, and time is all that passes.
  for (int hour = 0; hour < 30 * 24; ++hour) old.guide().step(Seconds{3600});
  for (Session* session : {&young, &old}) {
    // The first touch of a day only brings the first screen back.
    for (int touch = session->guide().is_attracting() ? 2 : 1; touch > 0; --touch) {
      session->touch(input::InputEvent::Kind::Down, 1, 0.9F, 0.1F);
      session->touch(input::InputEvent::Kind::Up, 1, 0.9F, 0.1F);
      session->run(1);
    }
  }

  const float first = flow_in_a_second(young);

  EXPECT_NEAR(first, 0.35F, 0.001F);
  EXPECT_NEAR(flow_in_a_second(old), first, 0.001F);
}

TEST(Guide, BeginsWhereverTheWelcomeIsTouched) {
  Session session;
  session.touch(input::InputEvent::Kind::Down, 1, 0.9F, 0.1F);
  session.touch(input::InputEvent::Kind::Up, 1, 0.9F, 0.1F);
  session.run(0.1);

  EXPECT_EQ(session.guide().state().screen, interface::Screen::Choosing);
}

TEST(Guide, IsNotBegunByAPalmNorByAGlassThatIsPulledOut) {
  Session session;
  session.run(1);
  session.touch(input::InputEvent::Kind::Down, 1, 0.9F, 0.1F);
  session.run(0.05);
  session.touch(input::InputEvent::Kind::Cancel, 1, 0.9F, 0.1F);
  session.run(0.05);
  EXPECT_EQ(session.guide().state().screen, interface::Screen::Welcome);

  session.touch(input::InputEvent::Kind::Down, 1, 0.9F, 0.1F);
  session.touch(input::InputEvent::Kind::Up, 1, 0.9F, 0.1F);
  session.run(0.05);
  EXPECT_EQ(session.guide().state().screen, interface::Screen::Choosing);
}

TEST(Guide, AnswersATouchByARingInTheNextFrame) {
  Session session;
  EXPECT_EQ(rings(session), 0U);

  session.touch(input::InputEvent::Kind::Down, 1, 0.5F, 0.5F);
  session.touch(input::InputEvent::Kind::Down, 2, 0.7F, 0.5F);
  session.run(1.0 / 60);

  EXPECT_EQ(rings(session), 2U);
}

TEST(Guide, SetsOutInTheFrameAfterAnExhibitIsChosen) {
  Session session;
  session.tap("begin");
  session.tap(first_exhibit());
  session.run(1);

  EXPECT_EQ(session.guide().state().screen, interface::Screen::Walking);
  EXPECT_EQ(session.guide().draw_list().ribbons.size(), 1U);
  EXPECT_NE(session.guide().state_of(0), AvatarState::Idle);
}

TEST(Guide, GoesToAnExhibitTouchedOnTheModel) {
  Session session;
  session.tap("begin");
  session.run(2);
  std::uint32_t last = 0;  // of the kiosk's floor
  for (std::uint32_t i = 0; i < test::sample_museum().exhibits.size(); ++i)
    if (test::sample_museum().exhibits[i].floor == test::sample_museum().kiosk_floor) last = i;
  session.tap("exhibit:" + test::sample_museum().exhibits[last].id, interface::Role::Spot);

  EXPECT_EQ(session.guide().state().exhibit, last);
}

TEST(Guide, ArrivesAndSuggestsWhatIsCloseBy) {
  Session session;
  session.tap("begin");
  session.tap(first_exhibit());
  session.run(16);

  EXPECT_EQ(session.guide().state().screen, interface::Screen::Arrived);
  EXPECT_TRUE(session.guide().state().arrived);
  const Vec2 off = session.guide().crowd()[0].avatar.body.position -
                   test::sample_museum().exhibits[0].viewing_point.position;
  EXPECT_LT(std::hypot(off.x, off.y), 1.1);
}

TEST(Guide, LooksIntoABendBeforeItWalksIt) {
  Session session;
  session.tap("begin");
  session.run(2);
  session.tap("exhibit:" + test::sample_museum().exhibits[6].id, interface::Role::Spot);
  int led = 0, bends = 0;
  double gaze = session.guide().crowd()[0].avatar.manner.gaze.yaw;
  for (int i = 0; i < 60 * 20; ++i) {
    const Avatar& avatar = session.guide().crowd()[0].avatar;
    const double heading = avatar.body.heading;
    const double looked = avatar.manner.gaze.yaw;
    const bool looks_at_visitor =
        avatar.manner.gesture != motion::Gesture::None || std::abs(looked) > 0.8;
    session.run(1.0 / 60);
    const double turned = std::remainder(session.guide().crowd()[0].avatar.body.heading - heading,
                                         2 * std::numbers::pi);
    EXPECT_LE(std::abs(looked), motion::most_gaze_yaw);
    EXPECT_LE(std::abs(looked - gaze), 0.08) << "the head jerks";
    gaze = looked;
    if (std::abs(turned) < 0.01 || looks_at_visitor) continue;
    ++bends;
    if (looked * turned > 0) ++led;
  }
  ASSERT_GT(bends, 20);
  EXPECT_GT(led, bends * 3 / 4);
}

TEST(Guide, GreetsTheNextVisitorInTheFirstLanguageAndWalksHome) {
  Session session;
  session.tap("begin");
  session.tap("language:ar");
  session.tap(first_exhibit());
  session.run(80);

  EXPECT_EQ(session.guide().state(), interface::InterfaceState{});
  const Vec2 off =
      session.guide().crowd()[0].avatar.body.position - test::sample_museum().kiosk.position;
  EXPECT_LT(std::hypot(off.x, off.y), 0.3);
}

TEST(Guide, BeginsEveryVisitAtYouAreHereWhereverTheLastOneEnded) {
  Session session;
  session.tap("begin");
  session.tap(first_exhibit());
  session.run(6);
  session.tap("home");
  session.run(0.5);
  const Vec2 left =
      session.guide().crowd()[0].avatar.body.position - test::sample_museum().kiosk.position;
  ASSERT_GT(std::hypot(left.x, left.y), 1.0) << "it is still walking home";

  session.tap("begin");
  session.run(0.1);

  const Agent& guide = session.guide().crowd()[0];
  const Vec2 off = guide.avatar.body.position - test::sample_museum().kiosk.position;
  EXPECT_LT(std::hypot(off.x, off.y), 0.01);
  EXPECT_TRUE(guide.is_here);
  session.tap(first_exhibit());
  session.run(16);
  EXPECT_EQ(session.guide().state().screen, interface::Screen::Arrived);
}

TEST(Guide, OutlinesWhatTheKeypadWouldPressAndCoversNothingOfIt) {
  Session session;
  session.tap("begin");
  session.run(1);
  const std::size_t before = session.guide().draw_list().quads.size();
  session.key(input::Key::Down);
  session.run(1);

  const auto& quads = session.guide().draw_list().quads;
  ASSERT_EQ(quads.size(), before + 2);
  for (std::size_t i = before; i < quads.size(); ++i)
    EXPECT_EQ(quads[i].fill, scene::QuadFill::Frame);
}

TEST(Guide, GoesToAnExhibitTouchedOnTheModelOfTheWelcome) {
  Session session;
  session.run(1);
  session.tap(first_exhibit(), interface::Role::Spot);

  EXPECT_EQ(session.guide().state().exhibit, 0U);
  EXPECT_EQ(session.guide().state().screen, interface::Screen::Walking);
}

std::size_t dots_of_seconds(Session& session) {
  const scene::Rect ring = session.guide().view()->countdown;
  const auto& quads = session.guide().draw_list().quads;
  return static_cast<std::size_t>(std::ranges::count_if(quads, [&](const scene::Quad& quad) {
    return quad.colour == scene::Theme{}.focus && quad.fill == scene::QuadFill::Solid &&
           scene::contains(ring, quad.rect.x, quad.rect.y);
  }));
}

TEST(Guide, AsksWhoeverTouchesNothingWhetherTheyAreStillThereAndATouchAnywhereSaysSo) {
  Session session;
  session.tap("begin");
  session.run(14);
  ASSERT_TRUE(session.guide().state().asks_to_stay);
  EXPECT_NEAR(static_cast<double>(dots_of_seconds(session)), 6, 1);
  session.run(3);
  EXPECT_NEAR(static_cast<double>(dots_of_seconds(session)), 3, 1);

  session.touch(input::InputEvent::Kind::Down, 1, 0.1F, 0.25F);
  session.touch(input::InputEvent::Kind::Up, 1, 0.1F, 0.25F);
  session.run(0.1);

  EXPECT_FALSE(session.guide().state().asks_to_stay);
  EXPECT_EQ(session.guide().state().screen, interface::Screen::Choosing) << "nothing else happens";
  session.run(13);
  EXPECT_EQ(session.guide().state().screen, interface::Screen::Choosing);
  session.run(8);
  EXPECT_EQ(session.guide().state(), interface::InterfaceState{});
}

TEST(Guide, LetsStartingOverBeTakenBackForFiveSeconds) {
  Session session;
  session.tap("begin");
  session.tap(first_exhibit());
  session.run(3);
  session.tap("home");
  session.run(2);
  session.tap("resume");

  EXPECT_EQ(session.guide().state().screen, interface::Screen::Walking);
  EXPECT_EQ(session.guide().state().exhibit, 0U);
  session.run(20);
  EXPECT_EQ(session.guide().state().screen, interface::Screen::Arrived);

  session.tap("home");
  session.run(5.5);
  EXPECT_FALSE(session.guide().state().can_resume);
  EXPECT_EQ(
      std::ranges::count(session.guide().view()->controls, "resume", &interface::Control::name), 0);
}

TEST(Guide, KeepsNothingOfTheLastVisitorForTheNext) {
  Session session;
  session.tap("begin");
  session.tap("language:ar");
  session.tap("route:offset");
  session.tap("collect:" + test::sample_museum().exhibits.front().id);
  session.tap("home");
  session.run(21);

  EXPECT_EQ(session.guide().state(), interface::InterfaceState{});
}

TEST(Guide, DoesNotLeaveAVisitorWhoFollows) {
  Session session;
  session.tap("begin");
  session.tap("page:next");
  session.tap("page:next");
  session.tap("exhibit:" + test::sample_museum().exhibits[18].id);
  session.run(22);  // longer than the idle time, shorter than the way

  EXPECT_EQ(session.guide().state().screen, interface::Screen::Walking);
}

/// Are the guide and what it is about to walk, and the goal where it is near, in the picture?
bool shows_the_walk(Session& session) {
  const scene::DrawList& list = session.guide().draw_list();
  const Avatar& guide = session.guide().crowd()[0].avatar;
  const plan::Plan& way = *guide.plan;
  const scene::Rect free = session.guide().view()->free;
  const auto shows = [&](Vec2 place) {
    const auto at = scene::project(list.camera, to_world(place, guide.height));
    return at && scene::contains(free, at->x, at->y);
  };
  bool all = shows(guide.body.position);
  const double left = way.reach.empty() ? 0 : way.reach.back() - guide.along;
  for (double metres = 1; metres <= std::min(left, 6.0); ++metres)
    all = all && shows(plan::point_along(way, guide.along + metres));
  return all && (left > 12 || way.points.empty() || shows(way.points.back()));
}

TEST(Guide, TurnsThePictureToTheNewWayWithinASecondAndAHalfOfAChangeOfMind) {
  for (const std::size_t second : {0UL, 4UL, 7UL}) {
    Session session;
    session.key(input::Key::Enter);
    session.run(1.5);
    // Near, and no thing that one looks at from so near that the guide is out of view.
    session.tap("exhibit:standing-king", interface::Role::Spot);
    session.run(10);
    EXPECT_TRUE(shows_the_walk(session));
    session.key(input::Key::Back);
    session.run(0.5);
    session.tap("exhibit:" + test::sample_museum().exhibits[second].id, interface::Role::Spot);
    session.run(1.5);
    for (int i = 0; i < 1200 && session.guide().state().screen == interface::Screen::Walking; ++i) {
      ASSERT_TRUE(shows_the_walk(session))
          << test::sample_museum().exhibits[second].id << " after " << i;
      session.run(1.0 / 60);
    }
  }
}

TEST(Guide, LeavesTheWallStandingThatAnExhibitHangsOn) {
  const auto hung =
      std::ranges::find(test::sample_museum().exhibits, ExhibitPlace::OnWall, &Exhibit::place);
  ASSERT_NE(hung, test::sample_museum().exhibits.end());
  Session session;
  session.key(input::Key::Enter);
  session.run(1.5);
  session.tap("exhibit:" + hung->id, interface::Role::Spot);
  for (int i = 0; i < 80 && !session.guide().state().arrived; ++i) session.run(1);
  session.run(2);

  ASSERT_TRUE(session.guide().state().arrived);
  const scene::WallLevels& walls = session.guide().draw_list().walls;
  const auto index = [](double metres) {
    return static_cast<int>(std::floor(metres / scene::WallLevels::cell)) &
           (scene::WallLevels::side - 1);
  };
  const Vec2 at = hung->placement.position;
  EXPECT_EQ(
      walls.level[static_cast<std::size_t>(index(at.y) * scene::WallLevels::side + index(at.x))],
      0);
}

/// Is all of the way in the picture, on the floor that is shown?
bool shows_the_whole_way(Session& session) {
  const scene::DrawList& list = session.guide().draw_list();
  const scene::Rect free = session.guide().view()->free;
  const double height = session.guide().crowd()[0].avatar.height;
  return !list.ribbon_point.empty() && std::ranges::all_of(list.ribbon_point, [&](Vec2 place) {
    const auto at = scene::project(list.camera, to_world(place, height));
    return at && scene::contains(free, at->x, at->y);
  });
}

TEST(Guide, ShowsTheWholeWayAtOnceAndThenTheCameraGoesAlong) {
  Session session;
  session.key(input::Key::Enter);
  session.run(1.5);
  session.tap(first_exhibit());
  session.run(1);
  EXPECT_TRUE(shows_the_whole_way(session));
  EXPECT_EQ(session.guide().state().pace, 0);
  EXPECT_NE(session.guide().crowd()[0].avatar.gait, motion::Gait::Idle);

  session.run(5);
  EXPECT_EQ(session.guide().state().pace, 1);
  EXPECT_TRUE(shows_the_walk(session));
}

/// Metres that the guide walks in two seconds of a walk, `Walk with me` pressed so often before.
double metres_in_two_seconds(int presses) {
  Session session;
  session.key(input::Key::Enter);
  session.run(1.5);
  session.tap("exhibit:" + test::sample_museum().exhibits[8].id, interface::Role::Spot);
  session.run(3);
  for (int i = 0; i < presses; ++i) session.tap("walk");
  const Vec2 before = session.guide().crowd()[0].avatar.body.position;
  session.run(2);
  return glm::distance(session.guide().crowd()[0].avatar.body.position, before);
}

TEST(Guide, IsFollowedAtWalkingPaceOrTwoOrFourTimesAsFast) {
  const double walking = metres_in_two_seconds(1);

  EXPECT_GT(walking, 1.5);
  EXPECT_GT(metres_in_two_seconds(2), 1.6 * walking);
  EXPECT_GT(metres_in_two_seconds(3), 2.5 * walking);
  EXPECT_LT(metres_in_two_seconds(4), 1.6 * walking);
}

TEST(Guide, StopsWhereItIs) {
  Session session;
  session.tap("begin");
  session.tap(first_exhibit());
  session.run(2.5);
  session.tap("stop");
  session.run(6);

  const Vec2 at = session.guide().crowd()[0].avatar.body.position;
  session.run(2);
  EXPECT_EQ(session.guide().crowd()[0].avatar.body.position, at);
  EXPECT_EQ(session.guide().state().screen, interface::Screen::Choosing);
}

/// Room for a trail of so many points.
scene::DrawList list_with_room(std::size_t ribbons, std::size_t points) {
  scene::DrawList list;
  list.ribbons.reserve(ribbons);
  list.ribbon_point.reserve(points);
  return list;
}

TEST(ATrail, HasTheColourOfItsGuideAndIsAsLongAsTheWay) {
  Session session;
  session.tap("begin");
  session.tap(first_exhibit());
  session.run(2.5);
  const Avatar& guide = session.guide().crowd()[0].avatar;
  scene::DrawList list = list_with_room(2, 4096);
  list.ribbon_point.resize(7);  // another's

  draw_trail(guide, 0, list);

  ASSERT_EQ(list.ribbons.size(), 1U);
  const scene::RibbonDraw& trail = list.ribbons.front();
  EXPECT_EQ(trail.look, guide.look);
  EXPECT_EQ(trail.first, 7U);
  EXPECT_EQ(trail.first + trail.count, list.ribbon_point.size());
  EXPECT_FLOAT_EQ(trail.length, static_cast<float>(guide.plan->reach.back()));
  EXPECT_FLOAT_EQ(trail.walked, static_cast<float>(guide.along));
  EXPECT_GT(trail.walked, 0);
}

TEST(ATrail, IsLeftOutWhereTheDrawListHasNoMoreRoom) {
  Session session;
  session.tap("begin");
  session.tap(first_exhibit());
  session.run(4);
  const Avatar& guide = session.guide().crowd()[0].avatar;
  scene::DrawList no_ribbon = list_with_room(0, 4096);
  scene::DrawList no_points = list_with_room(1, 1);

  draw_trail(guide, 0, no_ribbon);
  draw_trail(guide, 0, no_points);

  EXPECT_TRUE(no_ribbon.ribbons.empty());
  EXPECT_TRUE(no_points.ribbons.empty());
}

TEST(Guide, AloneHasAWayInTheColourThatThePanelGivesItsKind) {
  Session session;
  session.tap("begin");
  session.tap(first_exhibit());
  session.run(1);

  EXPECT_FALSE(session.guide().draw_list().ribbons.front().look);
}

TEST(Guide, CanBeUsedByKeysAlone) {
  Session session;
  session.key(input::Key::Enter);
  session.run(0.5);
  EXPECT_EQ(session.guide().state().screen, interface::Screen::Choosing);
  session.key(input::Key::Down);  // how much time they have, and ...
  for (std::uint32_t tour = 0; tour < interface::tours_of_staff(test::sample_museum()); ++tour)
    session.key(input::Key::Down);  // ... tours come before the exhibits
  session.key(input::Key::Down);
  session.key(input::Key::Down);
  session.key(input::Key::Enter);
  session.run(0.5);
  EXPECT_EQ(session.guide().state().exhibit, 1U);

  session.key(input::Key::Back);
  session.run(0.5);
  EXPECT_EQ(session.guide().state().screen, interface::Screen::Choosing);
}

TEST(Guide, LeadsToTheNearestToiletsByOneTouchFromEveryScreen) {
  Session session;
  session.tap("toilets");
  session.run(1);
  EXPECT_EQ(session.guide().state().screen, interface::Screen::Walking);
  const auto place = session.guide().state().place;
  ASSERT_TRUE(place);
  EXPECT_TRUE(answers(test::sample_museum().places[*place].kind, PlaceKind::Toilets));
  for (int i = 0; i < 60 && !session.guide().state().arrived; ++i) session.run(1);

  EXPECT_EQ(session.guide().state().screen, interface::Screen::Arrived);
  EXPECT_LT(glm::distance(session.guide().crowd()[0].avatar.body.position,
                          test::sample_museum().places[*place].standing),
            0.02);
  session.tap("places");
  session.run(0.5);
  session.tap("place:cafe");
  session.run(0.5);
  EXPECT_EQ(session.guide().state().seeks, PlaceKind::Cafe);
  session.tap("toilets");
  session.run(0.5);
  EXPECT_EQ(session.guide().state().place, place);
}

TEST(Guide, IsSentToAPlaceByItsSignOnTheModel) {
  Session session;
  session.tap("begin");
  session.run(1.5);
  session.tap("spot:shop", interface::Role::Spot);
  session.run(1);

  ASSERT_TRUE(session.guide().state().place);
  EXPECT_EQ(test::sample_museum().places[*session.guide().state().place].id, "shop");
  EXPECT_FALSE(session.guide().state().seeks);
}

TEST(Guide, ComesToTheHelpsLastByKeys) {
  Session session;
  session.key(input::Key::Enter);
  session.run(0.5);
  session.key(input::Key::Up);  // from the first thing round to the last
  session.key(input::Key::Up);
  session.key(input::Key::Enter);
  session.run(0.5);

  EXPECT_EQ(session.guide().state().seeks, PlaceKind::Toilets);
}

bool are_apart(const scene::Rect& a, const scene::Rect& b) {
  return a.x >= b.x + b.width || b.x >= a.x + a.width || a.y >= b.y + b.height ||
         b.y >= a.y + a.height;
}

TEST(Guide, ShowsNoSignOverAnotherNorOverAName) {
  Session session;
  session.tap("begin");
  session.run(2);
  for (const std::uint32_t floor : {0U, 1U, 2U}) {
    session.tap("floor:" + test::sample_museum().floors[floor].plan.name);
    session.run(1.5);
    const interface::View& view = *session.guide().view();
    std::size_t signs = 0;
    for (const interface::FloorLabel& sign : view.labels) {
      if (!sign.is_sign || sign.rect.width <= 0) continue;
      ++signs;
      for (const interface::FloorLabel& other : view.labels) {
        if (&other == &sign) continue;
        EXPECT_TRUE(are_apart(sign.rect, other.rect))
            << view.controls[static_cast<std::size_t>(sign.control)].name;
      }
    }
    EXPECT_GE(signs, 3U);
  }
}

TEST(Guide, ShowsNoNameOfAGalleryUnderANumberNorUnderAnother) {
  Session session;
  session.tap("begin");
  session.run(2);
  for (const std::uint32_t floor : {0U, 1U, 2U}) {
    session.tap("floor:" + test::sample_museum().floors[floor].plan.name);
    session.run(1.5);
    const auto& labels = session.guide().view()->labels;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (labels[i].control >= 0 || labels[i].rect.width <= 0) continue;
      for (std::size_t j = 0; j < labels.size(); ++j)
        EXPECT_TRUE(i == j || labels[j].is_sign || labels[j].rect.width <= 0 ||
                    are_apart(labels[i].rect, labels[j].rect))
            << floor << ": " << i << ", " << j;
    }
  }
}

TEST(Guide, LeadsThroughTheTourThatAVisitorPutsTogether) {
  Session session;
  session.tap("begin");
  session.run(0.5);
  for (const std::uint32_t i : {2U, 0U, 1U})
    session.tap("collect:" + test::sample_museum().exhibits[i].id);
  session.run(0.5);

  EXPECT_TRUE(session.guide().state().own_tour.is_ordered) << "the worker has ordered it";
  EXPECT_GT(session.guide().state().own_tour.seconds, 3 * 30);
  EXPECT_TRUE(session.guide().shows_its_state());

  session.tap("own-tour");
  session.run(0.5);
  session.tap("start-tour");
  session.run(1);

  const interface::InterfaceState& state = session.guide().state();
  EXPECT_EQ(state.exhibit, state.own_tour.exhibit[0]);
  EXPECT_EQ(state.tour, (interface::TourWalk{interface::TourWalk::own, 0}));
  EXPECT_FALSE(session.guide().view()->remaining.empty());

  session.tap("home");

  EXPECT_EQ(session.guide().state().own_tour, interface::OwnTour{});
}

TEST(Guide, TurnsThePageWhenTheListIsSwiped) {
  Session session;
  session.tap("begin");
  session.touch(input::InputEvent::Kind::Down, 1, 0.3F, 0.4F);
  session.touch(input::InputEvent::Kind::Move, 1, 0.1F, 0.4F);
  session.run(0.1);
  session.touch(input::InputEvent::Kind::Up, 1, 0.1F, 0.4F);
  session.run(0.1);

  EXPECT_EQ(session.guide().state().page, 1U);
}

/// The sample museum twice, one above the other, with a lift beside the kiosk; upstairs is a copy
/// of the first exhibit.
Museum house_with_a_lift() {
  Museum house = test::sample_museum();
  const std::uint32_t ground = house.kiosk_floor;
  house.floors.push_back(house.floors[ground]);
  house.scenery.push_back(house.scenery[ground]);
  const auto upper = static_cast<std::uint32_t>(house.floors.size() - 1);
  FloorPlan& plan = house.floors.back().plan;
  plan.name = "copy";
  plan.ordinal = 9;
  plan.height = 40;
  const Placement stop{house.kiosk.position + Vec2(2, 0), 0};
  Connection lift;
  lift.id = "lift-to-the-copy";
  lift.kind = ConnectionKind::Lift;
  lift.step_free = true;
  lift.wait_seconds = 1;
  lift.seconds_per_floor = 6 / std::abs(9.0 - house.floors[ground].plan.ordinal);
  lift.stops = {{ground, stop}, {upper, stop}};
  house.connections = {lift};
  house.exhibits.push_back(house.exhibits.front());
  house.exhibits.back().id = "copy";
  house.exhibits.back().floor = upper;
  return house;
}

TEST(Guide, LeadsToAnotherFloorWhichComesIntoViewWhileTheModelIsBehindPaper) {
  const Museum house = house_with_a_lift();
  const auto upper = static_cast<std::uint32_t>(house.floors.size() - 1);
  Session session(house);
  session.tap("begin");
  session.run(1);
  session.tap("floor:copy");
  session.run(1);
  EXPECT_EQ(session.guide().draw_list().floor, upper);
  EXPECT_TRUE(session.guide().draw_list().avatars.empty()) << "it stands on the kiosk's floor";

  session.tap("exhibit:copy", interface::Role::Spot);
  Vec3 eye = session.guide().draw_list().camera.eye;
  std::uint32_t shown = session.guide().draw_list().floor;
  bool flew_down = false;
  for (int frame = 0; frame < 60 * 120 && !session.guide().state().arrived; ++frame) {
    session.run(1.0 / 60);
    const scene::DrawList& list = session.guide().draw_list();
    if (list.floor != shown) {
      EXPECT_GT(list.fade, 0.99F);
      flew_down = true;
    }
    if (flew_down && frame > 150 && !session.guide().state().arrived) {
      ASSERT_EQ(list.avatars.size(), 1U);
      EXPECT_LT(glm::distance(list.camera.eye, eye), 0.5F) << "frame " << frame;
    }
    shown = list.floor;
    eye = list.camera.eye;
  }

  EXPECT_TRUE(session.guide().state().arrived);
  EXPECT_EQ(session.guide().crowd()[0].avatar.floor, upper);
  EXPECT_EQ(shown, upper);
  EXPECT_EQ(session.guide().counters().collisions, 0U);

  session.tap("choose");
  session.run(1);
  EXPECT_EQ(session.guide().draw_list().floor, upper) << "that is where the visitor looked last";
  session.tap("back");
  session.run(1);
  session.tap("home");
  session.run(2);
  EXPECT_EQ(session.guide().draw_list().floor, house.kiosk_floor);
}

TEST(Guide, PlansAnewAtOnceWithoutStepsAndGoesAnyWayAgainWithTheNextVisitor) {
  Session session;
  session.tap("begin");
  session.run(1);
  session.tap("floor:upper");
  session.run(1);
  const auto upstairs = std::ranges::find(test::sample_museum().exhibits, 1U, &Exhibit::floor);
  session.tap("exhibit:" + upstairs->id, interface::Role::Spot);
  session.run(2);
  const auto taken = [&] {
    const auto& then = session.guide().crowd()[0].avatar.plan->then;
    return then ? test::sample_museum().connections[then->connection].id : std::string();
  };
  EXPECT_EQ(taken(), "grand-stairs");

  session.tap("step-free");
  session.run(2);
  EXPECT_EQ(taken(), "lift");
  EXPECT_TRUE(session.guide().state().ways.step_free);

  session.tap("home");
  session.run(1);
  EXPECT_FALSE(session.guide().state().ways.step_free);
}

TEST(Guide, WhoFindsNoWayWithoutStepsStopsAndGoesOnWhenAnyWayWillDo) {
  Museum house = test::sample_museum();
  for (Connection& connection : house.connections) connection.step_free = false;
  Session session(house);
  session.tap("begin");
  session.run(1);
  session.tap("floor:upper");
  session.run(1);
  const auto upstairs = std::ranges::find(house.exhibits, 1U, &Exhibit::floor);
  session.tap("exhibit:" + upstairs->id, interface::Role::Spot);
  session.run(2);

  session.tap("step-free");
  session.run(2);
  EXPECT_EQ(session.guide().state_of(0), AvatarState::Idle);
  EXPECT_EQ(session.guide().state().screen, interface::Screen::Walking) << "it says why";
  session.tap("step-free");
  session.run(3);
  EXPECT_EQ(session.guide().state_of(0), AvatarState::Walk);
}

TEST(Guide, DoesTheSameTwice) {
  const auto visit = [](Session& session) {
    session.tap("begin");
    session.tap(first_exhibit());
    session.run(3);
    session.tap("route:skeleton");
    session.run(4);
  };
  Session one, two;
  visit(one);
  visit(two);

  const scene::DrawList &a = one.guide().draw_list(), &b = two.guide().draw_list();
  ASSERT_EQ(a.palette.size(), b.palette.size());
  EXPECT_EQ(std::memcmp(a.palette.data(), b.palette.data(), a.palette.size() * sizeof(Mat4)), 0);
  EXPECT_EQ(a.camera.view, b.camera.view);
  EXPECT_EQ(a.quads.size(), b.quads.size());
}

TEST(Guide, SaysThatAnExhibitIsClosedAndLeadsThereOnceItIsOpen) {
  Session session;
  session.tap("begin");
  session.run(0.5);
  Closures closed;
  closed.doors.resize(test::sample_museum().floors.size());
  closed.exhibits = {{0}};
  session.close(closed);
  session.run(0.5);

  session.tap(first_exhibit());
  session.run(1);

  EXPECT_EQ(session.guide().state().screen, interface::Screen::Walking);
  EXPECT_TRUE(session.guide().view()->remaining.empty()) << "there is no way";
  EXPECT_EQ(session.guide().state_of(0), AvatarState::Idle);

  closed.exhibits.clear();
  session.close(closed);
  session.run(1);

  EXPECT_FALSE(session.guide().view()->remaining.empty());
  EXPECT_NE(session.guide().state_of(0), AvatarState::Idle) << "it turns, or walks";
}

TEST(Guide, StopsOnItsWayToAnExhibitThatIsClosedAndSaysSo) {
  Session session;
  session.tap("begin");
  session.run(0.5);
  session.tap(first_exhibit());
  session.run(3);
  ASSERT_EQ(session.guide().state_of(0), AvatarState::Walk);
  Closures closed;
  closed.doors.resize(test::sample_museum().floors.size());
  closed.exhibits = {{0}};

  session.close(closed);
  session.run(4);

  EXPECT_EQ(session.guide().state_of(0), AvatarState::Idle);
  EXPECT_FALSE(session.guide().state().arrived);
}

}  // namespace
}  // namespace docent::guide::guide_test
