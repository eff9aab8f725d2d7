#include "runtime/guide/step_aside.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "runtime/guide/guide.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::step_aside_test {
namespace {

interface::Goal goal_at(std::uint32_t exhibit) {
  interface::InterfaceState state;
  state.exhibit = exhibit;
  return *interface::goal_of(test::sample_museum(), state);
}

double turned(double from, double to) {
  return std::abs(std::remainder(to - from, 2 * std::numbers::pi));
}

double direction(Vec2 line) {
  return std::atan2(line.y, line.x);
}

TEST(StepAside, FindsAPlaceBesideEveryExhibitThatHidesNothingAndTouchesNothing) {
  const auto shapes = exhibit_shapes(test::sample_museum());
  std::size_t found = 0;
  for (std::uint32_t i = 0; i < test::sample_museum().exhibits.size(); ++i) {
    const interface::Goal goal = goal_at(i);
    const auto map = path::make_floor_map(test::sample_museum().floors[goal.floor]);
    const Vec2 towards = glm::normalize(goal.position - goal.standing.position);
    const Placement comes{goal.standing.position - 1.5 * towards, direction(towards)};
    const Placement from = map->has_room(comes.position, 0.25) ? comes : goal.standing;

    const auto place =
        place_aside(*map, goal, shapes[i], from, {}, test::sample_museum().body_radius);

    if (!place) continue;
    ++found;
    EXPECT_TRUE(map->has_room(place->position, test::sample_museum().body_radius)) << i;
    EXPECT_GT(distance_to(shapes[i], place->position), test::sample_museum().body_radius) << i;
    // The body leaves the line free along which one looks from the viewing point.
    const Vec2 off = place->position - goal.standing.position;
    EXPECT_GT(std::abs(cross(towards, off)), test::sample_museum().body_radius + 0.3) << i;
    // Half turned: neither has it its back to the exhibit nor to the visitor.
    const Vec2 exhibit = to_floor(shapes[i].middle);
    const double visitor = arrival_yaw(goal, place->position) + std::numbers::pi;
    EXPECT_LT(turned(place->heading, direction(exhibit - place->position)), 1.2) << i;
    EXPECT_LT(turned(place->heading, visitor), 1.7) << i;
  }
  EXPECT_GE(found * 10, test::sample_museum().exhibits.size() * 9) << found;
}

TEST(StepAside, LooksOverTheShoulderOnWhoseSideTheGuideIsNot) {
  const interface::Goal goal{.floor = 0, .standing = {{0, 0}, 0}, .position = {1.2, 0}};
  EXPECT_GT(arrival_yaw(goal, {0.2, 0.9}), 0);
  EXPECT_LT(arrival_yaw(goal, {0.2, -0.9}), 0);
}

TEST(StepAside, EndsBesideTheExhibitPointsAtItAndTellsSo) {
  plan::Planner planner(test::sample_museum(), {test::boxes, {}});
  Guide guide(test::sample_museum(), planner, {.shape = {.width = 1920, .height = 1080}});
  test::run(planner, guide, 0.2);
  const auto tap = [&](std::string_view name) {
    const auto& controls = guide.view()->controls;
    const auto control = std::ranges::find(controls, name, &interface::Control::name);
    ASSERT_NE(control, controls.end()) << name;
    const input::Contact finger{1, control->rect.x + control->rect.width / 2,
                                control->rect.y + control->rect.height / 2};
    for (const auto kind : {input::InputEvent::Kind::Down, input::InputEvent::Kind::Up}) {
      guide.touch({.kind = kind, .contact = finger});
      test::run(planner, guide, 1.0 / 60);
    }
  };
  tap("begin");
  test::run(planner, guide, 0.1);
  EXPECT_EQ(guide.state_of(0), AvatarState::Gesture) << "it greets";
  test::run(planner, guide, 0.5);
  tap("exhibit:" + test::sample_museum().exhibits[1].id);
  bool gestured = false;
  for (int i = 0; i < 60 * 60 && !guide.state().arrived; ++i) {
    test::run(planner, guide, 1.0 / 60);
    ASSERT_EQ(guide.counters().collisions, 0U);
  }
  ASSERT_TRUE(guide.state().arrived);
  EXPECT_EQ(guide.counters().routes, 1U);
  for (int i = 0; i < 120; ++i) {
    test::run(planner, guide, 1.0 / 60);
    gestured = gestured || guide.state_of(0) == AvatarState::Gesture;
  }
  EXPECT_TRUE(gestured);
  const Avatar& avatar = guide.crowd()[0].avatar;
  EXPECT_EQ(avatar.manner.gesture, motion::Gesture::Point);
  const interface::Goal goal = goal_at(1);
  const Vec2 towards = glm::normalize(goal.position - goal.standing.position);
  EXPECT_GT(std::abs(cross(towards, avatar.body.position - goal.standing.position)), 0.5);
}

}  // namespace
}  // namespace docent::guide::step_aside_test
