#include "runtime/guide/closer_look.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/guide/guide.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::closer_look_test {
namespace {

using Kind = input::InputEvent::Kind;
constexpr float aspect = 16.0F / 9, frame = 1.0F / 60;
constexpr scene::Rect free{0.37F, 0, 0.63F, 0.93F};

WholeModel hall(double yaw) {
  const std::array outline{Vec2{-20, -12}, Vec2{24, -12}, Vec2{24, 16}, Vec2{-20, 16}};
  return whole_model(outline, 4, yaw, free, aspect);
}

input::Finger finger(std::uint32_t id, Vec2 from, Vec2 at) {
  input::Finger one;
  one.start = {.id = id, .x = static_cast<float>(from.x), .y = static_cast<float>(from.y)};
  one.at = {.id = id, .x = static_cast<float>(at.x), .y = static_cast<float>(at.y)};
  return one;
}

/// What of the floor a point of the glass shows.
Vec2 ground(const WholeModel& model, const CloserLook& look, Vec2 at) {
  const auto view = scene::view_of(look.applied_to(model.rig), aspect);
  const auto point = scene::point_at_height(
      view, {static_cast<float>(at.x), static_cast<float>(at.y)}, model.rig.target.y);
  return point ? to_floor(*point) : Vec2{1e9, 1e9};
}

double most(Vec2 of) {
  return std::max(of.x, of.y);
}

Vec2 any_place() {
  const auto share = [] { return 0.01 * *rc::gen::inRange(15, 85); };
  return {free.x + share() * free.width, free.y + share() * free.height};
}

RC_GTEST_PROP(ACloserLook, KeepsWhatLiesUnderTwoFingersUnderThemAsFarAsTheModelReaches, ()) {
  const WholeModel model = hall(0.1 * *rc::gen::inRange(0, 63));
  CloserLook look;
  const Vec2 a = any_place(), b = any_place(), c = any_place(), d = any_place();
  RC_PRE(glm::distance(a, b) > 0.05 && glm::distance(c, d) > 0.05);
  const auto fingers = [&](double share) {
    return std::array{finger(1, a, glm::mix(a, c, share)), finger(2, b, glm::mix(b, d, share))};
  };
  look.step(fingers(0), model, aspect, frame);
  RC_ASSERT(!look.has_moved(1) && !look.has_moved(2));
  int begun = 0;
  while (begun < 20 && !look.has_moved(1)) look.step(fingers(0.05 * ++begun), model, aspect, frame);
  RC_ASSERT(look.has_moved(1) == look.has_moved(2));
  RC_ASSERT(look.has_moved(1) == (most(glm::max(glm::abs(c - a), glm::abs(d - b))) > 0.02));
  if (!look.has_moved(1)) return;
  const Vec2 under_a = ground(model, look, glm::mix(a, c, 0.05 * begun)),
             under_b = ground(model, look, glm::mix(b, d, 0.05 * begun));
  RC_PRE(glm::distance(under_a, under_b) > 1);
  for (int i = begun + 1; i <= 20; ++i) {
    look.step(fingers(0.05 * i), model, aspect, frame);
    RC_ASSERT(look.nearness() >= 1 && look.nearness() <= CloserLook::nearest);
  }
  const double before = glm::distance(under_a, under_b);
  const double now = glm::distance(ground(model, look, c), ground(model, look, d));
  const Vec2 held = (under_a + under_b) / 2.0;
  const Vec2 seen = (ground(model, look, c) + ground(model, look, d)) / 2.0;
  const Vec2 target = to_floor(look.applied_to(model.rig).target) - to_floor(model.rig.target);
  const bool is_at_end = look.nearness() == 1 || look.nearness() == CloserLook::nearest;
  if (!is_at_end) RC_ASSERT(std::abs(now / before - 1) < 0.02);
  // Where nothing is in its way the middle between the fingers stays what it was.
  const double room = (1 - 1 / look.nearness()) * 11;
  if (!is_at_end && glm::length(target) < room)
    RC_ASSERT(glm::distance(held, seen) < 0.02 * before);
}

TEST(ACloserLook, ShowsNothingButTheWholeModelUntilTwoFingersDrawItNearer) {
  const WholeModel model = hall(0.3);
  CloserLook look;
  for (int i = 0; i < 30; ++i)
    look.step(std::array{finger(1, {0.6, 0.4}, {0.6 + 0.01 * i, 0.4})}, model, aspect, frame);

  EXPECT_EQ(look.applied_to(model.rig).target, model.rig.target);
  EXPECT_FALSE(look.has_moved(1)) << "so it may press";
}

TEST(ACloserLook, MovesUnderOneFingerOnceItIsNearerAndNotBeyondTheModel) {
  const WholeModel model = hall(0);
  CloserLook look;
  for (int i = 0; i <= 20; ++i)
    look.step(std::array{finger(1, {0.6, 0.5}, {0.6 - 0.01 * i, 0.5}),
                         finger(2, {0.7, 0.5}, {0.7 + 0.01 * i, 0.5})},
              model, aspect, frame);
  ASSERT_GT(look.nearness(), 2);
  EXPECT_TRUE(look.has_moved(1) && look.has_moved(2));
  look.step({}, model, aspect, frame);
  EXPECT_FALSE(look.has_moved(1)) << "another finger may have its number";

  const Vec2 from{0.6, 0.5};
  look.step(std::array{finger(3, from, from)}, model, aspect, frame);
  const Vec2 held = ground(model, look, {0.63, 0.5});
  look.step(std::array{finger(3, from, {0.61, 0.5})}, model, aspect, frame);
  EXPECT_FALSE(look.has_moved(3)) << "it trembles";
  look.step(std::array{finger(3, from, {0.63, 0.5})}, model, aspect, frame);
  EXPECT_TRUE(look.has_moved(3));
  look.step(std::array{finger(3, from, {0.65, 0.55})}, model, aspect, frame);
  EXPECT_LT(glm::distance(held, ground(model, look, {0.65, 0.55})), 0.01);
  for (int i = 0; i < 300; ++i)
    look.step(std::array{finger(3, from, {0.65 + i, 0.55 + i})}, model, aspect, frame);
  const Vec2 middle = to_floor(look.applied_to(model.rig).target);
  EXPECT_TRUE(middle.x >= -20 && middle.x <= 24 && middle.y >= -12 && middle.y <= 16);
}

TEST(ACloserLook, GoesBackToTheWholeSoftlyOrAtOnce) {
  const WholeModel model = hall(0);
  const std::array apart{finger(1, {0.6, 0.5}, {0.4, 0.5}), finger(2, {0.7, 0.5}, {0.9, 0.5})};
  const std::array begun{finger(1, {0.6, 0.5}, {0.57, 0.5}), finger(2, {0.7, 0.5}, {0.73, 0.5})};
  const std::array together{finger(1, {0.6, 0.5}, {0.6, 0.5}), finger(2, {0.7, 0.5}, {0.7, 0.5})};
  CloserLook softly, at_once;
  for (CloserLook* look : {&softly, &at_once}) {
    look->step(together, model, aspect, frame);
    look->step(begun, model, aspect, frame);
    look->step(apart, model, aspect, frame);
    look->step({}, model, aspect, frame);
    ASSERT_GT(look->nearness(), 2);
  }
  softly.end(false);
  at_once.end(true);
  EXPECT_EQ(at_once.nearness(), 1);
  softly.step({}, model, aspect, frame);
  EXPECT_GT(softly.nearness(), 1.5);
  for (int i = 0; i < 120; ++i) softly.step({}, model, aspect, frame);
  EXPECT_EQ(softly.nearness(), 1);
  EXPECT_EQ(softly.applied_to(model.rig).target, model.rig.target);
  EXPECT_FALSE(softly.is_moving());
}

// Through the glass.

class OnTheGlass : public testing::Test {
 protected:
  OnTheGlass() { test::run(planner_, guide_, 0.1); }

  void run(double seconds) { test::run(planner_, guide_, seconds); }
  void event(Kind kind, std::uint32_t id, Vec2 at) {
    guide_.touch(
        {.kind = kind, .contact = {id, static_cast<float>(at.x), static_cast<float>(at.y)}});
  }
  /// Two fingers about the middle of the model, from so far apart to so far apart.
  void pinch(double from, double to, Vec2 middle = {0.7, 0.45}) {
    for (const std::uint32_t id : {1U, 2U}) event(Kind::Down, id, at(id, from, middle));
    run(0.05);
    for (int i = 1; i <= 20; ++i) {
      for (const std::uint32_t id : {1U, 2U})
        event(Kind::Move, id, at(id, std::lerp(from, to, 0.05 * i), middle));
      run(1.0 / 60);
      expect_nothing_covered();
    }
    for (const std::uint32_t id : {1U, 2U}) event(Kind::Up, id, at(id, to, middle));
    run(0.2);
  }
  static Vec2 at(std::uint32_t id, double apart, Vec2 middle) {
    return middle + Vec2{(id == 1 ? -0.5 : 0.5) * apart, 0};
  }
  double distance() {
    const scene::CameraView& camera = guide_.draw_list().camera;
    return glm::distance(camera.eye, to_world(test::sample_museum().kiosk.position));
  }
  /// One whose disc is on the model, and where that is.
  std::pair<std::uint32_t, Vec2> shown_exhibit() {
    for (const interface::Control& control : guide_.view()->controls)
      if (control.role == interface::Role::Spot && control.rect.width > 0 &&
          control.action.kind == interface::Action::Kind::Choose)
        return {control.action.argument, Vec2{control.rect.x + control.rect.width / 2,
                                              control.rect.y + control.rect.height / 2}};
    ADD_FAILURE() << "no exhibit is seen";
    return {};
  }
  /// No disc that can be touched covers another, nor leaves the model; and all of them are seen.
  void expect_nothing_covered() {
    std::vector<scene::Rect> spots;
    for (const interface::Control& control : guide_.view()->controls)
      if (control.role == interface::Role::Spot && control.rect.width > 0)
        spots.push_back(control.rect);
    for (std::size_t i = 0; i < spots.size(); ++i) {
      const scene::Rect& one = spots[i];
      const float x = one.x + one.width / 2, y = one.y + one.height / 2;
      EXPECT_TRUE(std::ranges::any_of(guide_.draw_list().quads, [&](const scene::Quad& quad) {
        return quad.rect.width < 0.05F && quad.colour.a > 0.9F && scene::contains(quad.rect, x, y);
      }));
      EXPECT_TRUE(scene::contains(guide_.view()->free, x, y));
      for (std::size_t j = i + 1; j < spots.size(); ++j) {
        const scene::Rect& other = spots[j];
        const bool apart =
            one.x + one.width <= other.x + 1e-4F || other.x + other.width <= one.x + 1e-4F ||
            one.y + one.height <= other.y + 1e-4F || other.y + other.height <= one.y + 1e-4F;
        EXPECT_TRUE(apart) << i << " " << j;
      }
    }
  }

  plan::Planner planner_{test::sample_museum(), {test::boxes, {}}};
  Guide guide_{test::sample_museum(),
               planner_,
               {.shape = {.width = 1920, .height = 1080}, .idle_reset = Seconds{60}}};
};

TEST_F(OnTheGlass, TwoFingersDrawTheModelNearerAndChooseNothing) {
  const double before = distance();

  pinch(0.1, 0.3);

  EXPECT_LT(distance(), 0.6 * before);
  EXPECT_EQ(guide_.state().screen, interface::Screen::Welcome);
  pinch(0.3, 0.05);
  run(1);
  EXPECT_NEAR(distance(), before, 1e-3) << "it is seen whole again";
}

TEST_F(OnTheGlass, AnExhibitIsTouchedWhereItHasBeenMovedTo) {
  pinch(0.1, 0.3);
  event(Kind::Down, 5, {0.6, 0.3});
  run(0.05);
  for (int i = 1; i <= 20; ++i) {
    event(Kind::Move, 5, {0.6 + 0.01 * i, 0.3 + 0.01 * i});
    run(1.0 / 60);
    expect_nothing_covered();
  }
  event(Kind::Up, 5, {0.8, 0.5});
  run(0.2);
  ASSERT_EQ(guide_.state().screen, interface::Screen::Welcome)
      << "a finger that drags presses nothing";
  const auto [exhibit, middle] = shown_exhibit();
  event(Kind::Down, 6, middle);
  run(0.05);
  event(Kind::Up, 6, middle);
  run(0.05);

  EXPECT_EQ(guide_.state().exhibit, exhibit);
}

TEST_F(OnTheGlass, WhoBeginsSeesTheWholeModelAndSoDoesWhoComesNext) {
  const double before = distance();
  pinch(0.1, 0.3);
  run(25);
  EXPECT_NEAR(distance(), before, 1e-3) << "whoever drew it nearer has gone";

  test::tap(planner_, guide_, "begin");
  run(2);
  const double choosing = distance();
  pinch(0.1, 0.3);
  ASSERT_LT(distance(), 0.6 * choosing);
  test::tap(planner_, guide_, "home");
  run(2);
  EXPECT_NEAR(distance(), before, 1e-3);
}

TEST_F(OnTheGlass, AFingerChoosesAnExhibitWhileASleeveLiesOnTheModel) {
  const auto [exhibit, middle] = shown_exhibit();
  event(Kind::Down, 1, {0.7, 0.8});
  for (int i = 0; i < 60; ++i) {
    event(Kind::Move, 1, {0.7 + 0.001 * i, 0.8 + 0.002 * (i % 2)});  // it slides, and trembles
    run(1.0 / 60);
  }
  event(Kind::Down, 2, middle);
  run(0.05);
  event(Kind::Move, 1, {0.761, 0.8});
  run(0.05);
  event(Kind::Up, 2, middle);
  run(0.05);

  EXPECT_EQ(guide_.state().exhibit, exhibit);
}

TEST_F(OnTheGlass, FingersOnThePanelMoveNoModel) {
  test::tap(planner_, guide_, "begin");
  run(2);
  const double before = distance();
  pinch(0.05, 0.25, {0.18, 0.3});
  EXPECT_NEAR(distance(), before, 1e-3);
}

}  // namespace
}  // namespace docent::guide::closer_look_test
