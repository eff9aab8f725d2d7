// Who goes along with the guide may skip what is left of a room.
#include "runtime/guide/chapters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "runtime/guide/guide.h"
#include "runtime/model/exhibit/room_of.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::chapters_test {
namespace {

using interface::Chapter;

/// A visitor who goes along to an exhibit.
struct Walk {
  explicit Walk(std::string_view exhibit) {
    run(0.5);
    guide.touch(
        {.kind = input::InputEvent::Kind::KeyDown, .contact = {}, .key = input::Key::Enter});
    run(1.5);
    const auto it = std::ranges::find(test::sample_museum().exhibits, exhibit, &Exhibit::id);
    if (it->floor != test::sample_museum().kiosk_floor)
      tap("floor:" + test::sample_museum().floors[it->floor].plan.name);
    tap("exhibit:" + std::string(exhibit));
    run(2);
    tap("walk");
    run(1);
  }
  void run(double seconds) { test::run(planner, guide, seconds); }
  void tap(std::string_view name) { test::tap(planner, guide, name); }
  std::uint32_t room() const {
    const Avatar& one = guide.crowd()[0].avatar;
    return room_of(test::sample_museum(), one.floor, one.body.position);
  }
  /// Seconds until the guide no longer hurries.
  double seconds_of_haste() {
    int frames = 0;
    while (guide.state().skips && frames < 60 * 60) {
      run(1.0 / 60);
      ++frames;
    }
    return frames / 60.0;
  }

  GuideSettings settings{.shape = {.width = 1920, .height = 1080}, .idle_reset = Seconds{600}};
  plan::Planner planner{test::sample_museum(), {test::boxes, {}}};
  Guide guide{test::sample_museum(), planner, settings};
};

TEST(Chapters, AreTheRoomsOnTheWayAndThenTheGoal) {
  Walk walk("tripod-ding");
  ASSERT_EQ(walk.guide.state().next, Chapter::Room);
  std::vector<std::uint32_t> rooms{walk.room()};
  while (walk.guide.state().next == Chapter::Room && rooms.size() < 9) {
    walk.tap("onward");
    EXPECT_LT(walk.seconds_of_haste(), 3);
    EXPECT_NE(walk.room(), rooms.back());
    rooms.push_back(walk.room());
    walk.run(0.1);
  }

  EXPECT_GE(rooms.size(), 3U) << "the foyer, the court and the gallery at least";
  EXPECT_EQ(walk.guide.state().next, Chapter::Goal);
  EXPECT_EQ(walk.guide.state().screen, interface::Screen::Walking);
  walk.tap("onward");
  EXPECT_LT(walk.seconds_of_haste(), 4);
  walk.run(0.5);
  EXPECT_TRUE(walk.guide.state().arrived);
  EXPECT_FALSE(walk.guide.state().skips);
  EXPECT_EQ(walk.guide.counters().collisions, 0U);
}

TEST(Chapters, AreWalkedAtTheOldPaceAfterOneWasSkipped) {
  Walk walk("tripod-ding");
  walk.tap("onward");
  walk.seconds_of_haste();
  const Vec2 before = walk.guide.crowd()[0].avatar.body.position;
  walk.run(1);

  EXPECT_LT(glm::distance(walk.guide.crowd()[0].avatar.body.position, before), 2);
  EXPECT_EQ(walk.guide.state().pace, 1);
}

TEST(Chapters, AreSkippedByTheKeypadToo) {
  Walk walk("tripod-ding");
  const std::uint32_t room = walk.room();
  const auto key = [&](input::Key which) {
    walk.guide.touch({.kind = input::InputEvent::Kind::KeyDown, .contact = {}, .key = which});
    walk.run(0.05);
  };
  const auto& controls = walk.guide.view()->controls;
  const auto onward = std::ranges::find(controls, "onward", &interface::Control::name);
  ASSERT_NE(onward, controls.end());
  for (std::size_t i = 0; i < controls.size(); ++i) {
    key(input::Key::Down);
    const auto list = walk.guide.on_glass();
    const auto focused = std::ranges::find(list, true, &interface::OnGlass::has_focus);
    if (focused != list.end() && focused->name == "onward") break;
  }
  key(input::Key::Enter);
  EXPECT_TRUE(walk.guide.state().skips || walk.room() != room);
  walk.seconds_of_haste();

  EXPECT_NE(walk.room(), room);
}

TEST(Chapters, EndWhereOneHasComeToAnotherFloor) {
  const auto above = std::ranges::find_if(test::sample_museum().exhibits, [](const Exhibit& it) {
    return it.floor != test::sample_museum().kiosk_floor;
  });
  ASSERT_NE(above, test::sample_museum().exhibits.end());
  Walk walk(above->id);
  bool came_to_stairs = false;
  for (int i = 0; i < 20 && !walk.guide.state().arrived; ++i) {
    const Chapter next = walk.guide.state().next;
    const std::uint32_t floor = walk.guide.crowd()[0].avatar.floor;
    walk.tap("onward");
    EXPECT_LT(walk.seconds_of_haste(), 20);
    if (next == Chapter::Floor) {
      came_to_stairs = true;
      EXPECT_NE(walk.guide.crowd()[0].avatar.floor, floor);
    }
    walk.run(0.6);
  }

  EXPECT_TRUE(came_to_stairs);
  EXPECT_TRUE(walk.guide.state().arrived);
}

TEST(TheSmallPlan, IsOfTheFloorThatTheGuideIsOn) {
  const Museum& museum = test::sample_museum();
  const auto above = std::ranges::find_if(
      museum.exhibits, [&](const Exhibit& it) { return it.floor != museum.kiosk_floor; });
  ASSERT_NE(above, museum.exhibits.end());
  Walk walk(above->id);
  const auto plan = [&]() -> const interface::InsetPlan& { return walk.guide.view()->inset; };
  EXPECT_EQ(plan().floor, museum.kiosk_floor);
  for (int i = 0; i < 20 && !walk.guide.state().arrived; ++i) {
    walk.tap("onward");
    walk.seconds_of_haste();
    walk.run(0.6);
    EXPECT_EQ(plan().floor, walk.guide.crowd()[0].avatar.shown_floor);
    EXPECT_GT(plan().way.size(), 1U);
  }

  EXPECT_EQ(plan().floor, above->floor);
  EXPECT_LT(glm::distance(plan().way.back(), above->viewing_point.position), 0.05);
}

TEST(Chapters, AreNotOfferedToWhoSeesTheWholeWay) {
  Walk walk("tripod-ding");
  interface::InterfaceState state = walk.guide.state();
  state.pace = 0;
  const auto controls = interface::controls_of(test::sample_museum(), state, 5);

  EXPECT_EQ(std::ranges::find(controls, "onward", &interface::Control::name), controls.end());
}

}  // namespace
}  // namespace docent::guide::chapters_test
