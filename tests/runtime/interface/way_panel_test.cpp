#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "runtime/interface/layout.h"
#include "runtime/interface/on_glass.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/runtime/interface/seen.h"
#include "tests/support/sample_museum.h"

namespace docent::interface::way_panel_test {
namespace {

const Museum& museum() {
  static const Museum it = test::sample_museum_without_walls();
  return it;
}

/// From a word to the longest that is said.
ShownWay any_way() {
  const auto room = [] {
    return *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum().rooms.size()));
  };
  const auto side = [] {
    return static_cast<directions::Side>(*rc::gen::inRange(0, int{directions::side_count}));
  };
  ShownWay way;
  const auto parts = *rc::gen::inRange(1, 4);
  for (int i = 0; i < parts; ++i) {
    directions::FloorPart& part = way.directions.parts.emplace_back();
    part.room = room();
    for (auto doors = *rc::gen::inRange(0, 6); doors > 0; --doors)
      part.doors.push_back({part.room, room(), side(), *rc::gen::inRange(1U, 4U), 4});
    if (i + 1 < parts) part.then = directions::RideStep{ConnectionKind::Escalator, true, 0};
  }
  way.directions.goal = {
      .room = room(), .setting = directions::Setting::InCase, .where = directions::Where::Middle};
  way.directions.metres = 123;
  way.directions.seconds = 200;
  way.line = {{20, 2.6}, {20, 14}, {6, 14}};
  return way;
}

ViewRequest any_walk() {
  ViewRequest request;
  const auto shorter = *rc::gen::inRange(720U, 2161U);
  const double ratio = *rc::gen::element(4.0 / 3, 1.6, 16.0 / 9, 21.0 / 9);
  const auto longer = static_cast<std::uint32_t>(std::lround(shorter * ratio));
  const bool landscape = *rc::gen::arbitrary<bool>();
  request.shape.width = landscape ? longer : shorter;
  request.shape.height = landscape ? shorter : longer;
  request.shape.diagonal_inches = static_cast<float>(*rc::gen::inRange(24, 66));
  request.shape.text_scale = *rc::gen::element(1.0F, 1.4F, 2.0F);
  request.state.screen = *rc::gen::element(Screen::Walking, Screen::Arrived);
  request.state.arrived = request.state.screen == Screen::Arrived;
  request.state.language = *rc::gen::inRange(0U, 3U);
  request.state.exhibit =
      *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum().exhibits.size()));
  request.route_summary = RouteSummary{path::RouteStatus::Ok, 123, 200};
  return request;
}

bool overlap(const scene::Rect& a, const scene::Rect& b) {
  constexpr float slack = 1e-4F;
  return a.x + slack < b.x + b.width && b.x + slack < a.x + a.width &&
         a.y + slack < b.y + b.height && b.y + slack < a.y + a.height;
}

TEST(TheInsetPlan, LiesOnTheModelAndOnNothingElse) {
  EXPECT_TRUE(rc::check("apart from panel and controls", [] {
    const ViewRequest request = any_walk();
    const ShownWay way = any_way();
    PieceCache cache({test::boxes, {}}, 1, 1 << 20);
    const auto view = make_view(museum(), request, cache, {}, &way);
    const scene::Rect& board = view->inset.board;
    RC_ASSERT(board.width > 0);
    RC_ASSERT(board.x >= 0 && board.y >= 0 && board.x + board.width <= 1 &&
              board.y + board.height <= 1);
    RC_ASSERT(!overlap(board, view->panel));
    RC_ASSERT(board.width * board.height < 0.5F * view->free.width * view->free.height);
    for (const Control& control : view->controls)
      if (control.role != Role::Spot) RC_ASSERT(!overlap(board, control.rect));
    RC_ASSERT(view->free.width * view->free.height >= 0.55F);
    // The way lies on the board.
    for (const Vec2 point : view->inset.way) {
      const double u = dot(point - view->inset.origin, view->inset.right);
      const double v = dot(point - view->inset.origin, view->inset.down);
      RC_ASSERT(u > 0 && u < 1 && v > 0 && v < 1);
    }
  }));
}

TEST(TheInsetPlan, HasASpotOfTheGuidesOwnColourWhereVisitorsHaveGuidesOfTheirOwn) {
  ShownWay way;
  way.line = {{20, 2.6}, {20, 14}, {6, 14}};
  ViewRequest request;
  request.shape.width = 1920;
  request.shape.height = 1080;
  request.state.screen = Screen::Walking;
  request.state.exhibit = 3;
  request.route_summary = RouteSummary{path::RouteStatus::Ok, 25, 20};
  const auto spot = [&](std::optional<std::uint32_t> look) {
    request.state.look = look;
    PieceCache cache({test::boxes, {}}, 1, 1 << 20);
    const auto view = make_view(museum(), request, cache, {}, &way);
    EXPECT_GT(view->inset.board.width, 0);
    return scene::hex_of(view->inset.guide);
  };

  EXPECT_NE(spot(1), spot(2));
  EXPECT_NE(spot(1), spot({}));
  EXPECT_EQ(spot({}), scene::hex_of(scene::Theme{}.focus));
}

TEST(TheInsetPlan, HasNoLetterSmallerThanOthersOnAnyGlass) {
  ShownWay way;
  way.line = {{20, 2.6}, {20, 14}, {6, 14}};
  for (const float inches : {24.0F, 32.0F, 55.0F}) {
    ViewRequest request;
    request.shape.diagonal_inches = inches;
    request.state.screen = Screen::Walking;
    request.state.exhibit = 3;
    request.route_summary = RouteSummary{path::RouteStatus::Ok, 25, 20};
    PieceCache cache({test::boxes, {}}, 1, 1 << 20);
    const auto view = make_view(museum(), request, cache, {}, &way);
    const auto all = on_glass(museum(), *view, request.shape, 1e6F, 0);
    const auto north = std::ranges::find(all, "N", &OnGlass::label);
    ASSERT_NE(north, all.end());
    EXPECT_GT(north->text_mm, 4.9F) << inches;
  }
}

TEST(TheSentences, LieOverNoOtherTextAndNoControl) {
  EXPECT_TRUE(rc::check("in any language, in any size of letters", [] {
    const ViewRequest request = any_walk();
    const ShownWay way = any_way();
    PieceCache cache({test::boxes, {}}, 1, 1 << 20);
    const auto view = make_view(museum(), request, cache, {}, &way);
    const std::vector<scene::Rect> all = test::seen_texts(*view);
    for (const Control& control : view->controls)
      if (control.role != Role::Spot)
        RC_LOG() << control.name << ' ' << control.rect.x << ' ' << control.rect.y << ' '
                 << control.rect.width << ' ' << control.rect.height << '\n';
    for (const scene::Rect& text : all)
      for (const scene::Rect& other : all) {
        const bool are_apart = &other == &text || !overlap(text, other);
        if (!are_apart)
          RC_LOG() << text.x << ' ' << text.y << ' ' << text.width << ' ' << text.height << " and "
                   << other.x << ' ' << other.y << ' ' << other.width << ' ' << other.height
                   << '\n';
        RC_ASSERT(are_apart);
      }
    for (const Element& element : view->elements) {
      if (element.quad.fill != scene::QuadFill::Text || element.control >= 0) continue;
      const scene::Rect text =
          element.scrolls ? seen_of(view->scroll, element.quad.rect, 0) : element.quad.rect;
      for (const Control& control : view->controls)
        if (control.role != Role::Spot) RC_ASSERT(!overlap(text, control.rect));
    }
  }));
}

TEST(TheWay, IsShownOnTheGlassOfOneVisitorOnceSomethingIsChosen) {
  EXPECT_TRUE(shows_way({.screen = Screen::Walking}));
  EXPECT_TRUE(shows_way({.screen = Screen::Arrived}));
  EXPECT_FALSE(shows_way({.screen = Screen::Choosing}));
  EXPECT_FALSE(shows_way({.screen = Screen::Walking, .glass = Glass::Busy}));
}

}  // namespace
}  // namespace docent::interface::way_panel_test
