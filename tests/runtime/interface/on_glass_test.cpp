#include "runtime/interface/on_glass.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "runtime/interface/layout.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/runtime/interface/seen.h"
#include "tests/support/sample_museum.h"

namespace docent::interface::on_glass_test {
namespace {

using test::boxes;

/// The sample museum with as many exhibits as asked for, each with a title of some length.
Museum museum_of(std::uint32_t exhibits, std::uint32_t letters) {
  Museum museum = test::sample_museum_without_walls();
  const Exhibit pattern = museum.exhibits.front();
  museum.tours.clear();
  museum.exhibits.assign(exhibits, pattern);
  for (std::uint32_t i = 0; i < exhibits; ++i) {
    Exhibit& one = museum.exhibits[i];
    one.id = "e" + std::to_string(i);
    one.placement.position = {1 + (i * 7919U) % 380 / 10.0, 1 + (i * 104729U) % 300 / 10.0};
    one.viewing_point.position = one.placement.position;
    for (auto& [tag, title] : one.title) title = std::string(1 + (i * 31U) % letters, 'm');
  }
  return museum;
}

ViewRequest any_request(const Museum& museum) {
  ViewRequest request;
  const auto [width, height] =
      *rc::gen::element(std::pair{1024U, 768U}, std::pair{1280U, 720U}, std::pair{1920U, 1080U},
                        std::pair{3840U, 2160U}, std::pair{1080U, 1920U}, std::pair{2160U, 3840U});
  request.shape = {.width = width,
                   .height = height,
                   .diagonal_inches = *rc::gen::element(24.0F, 32.0F, 43.0F, 55.0F)};
  request.state.screen =
      *rc::gen::element(Screen::Welcome, Screen::Choosing, Screen::Walking, Screen::Arrived);
  request.state.language =
      *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum.languages.size()));
  request.state.exhibit = *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum.exhibits.size()));
  request.state.arrived = request.state.screen == Screen::Arrived;
  if (request.state.screen == Screen::Welcome) request.state.exhibit.reset();
  request.shape.text_scale = *rc::gen::element(1.0F, 1.4F, 2.0F);
  request.state.can_resume = request.state.screen == Screen::Welcome && *rc::gen::arbitrary<bool>();
  request.state.asks_to_stay =
      request.state.screen != Screen::Welcome && *rc::gen::inRange(0, 4) == 0;
  request.state.lists = *rc::gen::element(Listed::Exhibits, Listed::Places);
  request.state.large_letters = *rc::gen::inRange(0, 3) == 0;
  request.state.high_contrast = *rc::gen::inRange(0, 3) == 0;
  request.shape.mount_mm = *rc::gen::element(0.0F, 250.0F, 500.0F, 700.0F, 900.0F, 1000.0F);
  request.state.can_lower = can_be_lowered(request.shape);
  request.state.low_reach = request.state.can_lower && *rc::gen::arbitrary<bool>();
  if (*rc::gen::arbitrary<bool>())
    request.route_summary = RouteSummary{path::RouteStatus::Ok, 42.4, 55};
  return request;
}

/// Millimetres above the floor of a height on the glass.
float above_floor(const ScreenShape& shape, float y) {
  return shape.mount_mm + (1 - y) * glass_height_mm(shape);
}

TEST(LowReach, SaysHowLowAGlassHasToHangThatHangsTooHigh) {
  ScreenShape shape;
  shape.width = 1920;
  shape.height = 1080;
  shape.diagonal_inches = 24;  // 299 mm high
  shape.mount_mm = 1000;
  EXPECT_FALSE(mount_within_reach(shape).has_value());

  shape.mount_mm = 1150;
  ASSERT_TRUE(mount_within_reach(shape).has_value());
  EXPECT_NEAR(*mount_within_reach(shape), 1220 - 0.4 * 299, 1);
  shape.mount_mm = *mount_within_reach(shape);
  EXPECT_NEAR(above_floor(shape, low_reach_of(shape).top), 1220, 1);
  shape.mount_mm = 0;  // nobody has said
  EXPECT_FALSE(mount_within_reach(shape).has_value());
}

TEST(OnGlass, EveryControlIsSpokenAndWithLowReachWithinReachOfAWheelchair) {
  const Museum museum = museum_of(25, 30);
  EXPECT_TRUE(rc::check("from 380 to 1,220 mm", [&] {
    ViewRequest request = any_request(museum);
    request.state.low_reach = true;
    const ReachableBand band = low_reach_of(request.shape);
    PieceCache cache({boxes, {}}, 1, 1 << 20);
    const auto view = make_view(museum, request, cache);
    RC_ASSERT(view->speech.controls.size() == view->controls.size());
    for (std::size_t i = 0; i < view->controls.size(); ++i) {
      RC_ASSERT(!view->speech.controls[i].empty());
      const scene::Rect& rect = view->controls[i].rect;
      if (rect.width <= 0) continue;
      constexpr float pixel = 1;  // in millimetres, about
      const float highest = above_floor(request.shape, rect.y);
      const float lowest = above_floor(request.shape, rect.y + rect.height);
      RC_LOG() << view->controls[i].name << " " << lowest << " to " << highest << "\n";
      RC_ASSERT(rect.y >= band.top - 0.001F);
      RC_ASSERT(rect.y + rect.height <= band.bottom + 0.001F);
      const bool can_be = above_floor(request.shape, band.top) <= 1220 + pixel;
      if (request.shape.mount_mm > 0 && can_be) RC_ASSERT(highest <= 1220 + pixel);
      if (request.shape.mount_mm > 0) RC_ASSERT(lowest >= 380 - pixel);
    }
  }));
}

TEST(OnGlass, NothingCoversAnythingNorLeavesTheScreenInAnyMuseum) {
  EXPECT_TRUE(rc::check("1 to 5,000 exhibits, titles to 300 letters", [] {
    const Museum museum =
        museum_of(*rc::gen::element(1U, 3U, 25U, 300U, 5000U), *rc::gen::inRange(1U, 301U));
    const ViewRequest request = any_request(museum);
    PieceCache cache({boxes, {}}, 1, 1 << 20);
    const auto view = make_view(museum, request, cache);
    const auto items = on_glass(museum, *view, request.shape, 1e6F, -1);
    const auto covering = overlaps(items, request.shape);
    for (const auto& [a, b] : covering) {
      RC_LOG() << items[a].name << " '" << items[a].label << "' and " << items[b].name << " '"
               << items[b].label << "'\n";
      for (const std::size_t i : {a, b})
        RC_LOG() << items[i].rect.x << ' ' << items[i].rect.y << ' ' << items[i].rect.width << ' '
                 << items[i].rect.height << '\n';
    }
    RC_LOG() << request.shape.width << " x " << request.shape.height << ", "
             << request.shape.diagonal_inches << " inches, screen "
             << static_cast<int>(request.state.screen) << ", letters " << request.shape.text_scale
             << (request.state.asks_to_stay ? ", asks" : "")
             << (request.state.large_letters ? ", larger" : "")
             << (request.state.low_reach ? ", lowered" : "") << ", glass at "
             << request.shape.mount_mm << ", language " << request.state.language << '\n';
    RC_ASSERT(covering.empty());
    RC_ASSERT(outside(items, request.shape).empty());
  }));
}

TEST(OnGlass, EveryControlOfAScreenIsReached) {
  const Museum museum = museum_of(25, 300);
  for (const Screen screen :
       {Screen::Welcome, Screen::Choosing, Screen::Walking, Screen::Arrived}) {
    ViewRequest request;
    request.state.screen = screen;
    if (screen != Screen::Welcome) request.state.exhibit = 3;
    PieceCache cache({boxes, {}}, 1, 1 << 20);
    const auto view = make_view(museum, request, cache);
    const auto items = on_glass(museum, *view, request.shape, 1e6F, -1);

    for (std::size_t i = 0; i < view->controls.size(); ++i) {
      if (view->controls[i].role == Role::Spot) continue;
      EXPECT_GT(test::reached(*view, i).height, 0) << view->controls[i].name;
    }
  }
}

TEST(OnGlass, SaysHowHighLettersAreOnTheGlass) {
  const Museum museum = museum_of(3, 20);
  ViewRequest request;
  request.shape.diagonal_inches = 32;
  PieceCache cache({boxes, {}}, 1, 1 << 20);
  const auto view = make_view(museum, request, cache);
  const auto items = on_glass(museum, *view, request.shape, 1e6F, 0);

  const auto welcome = std::ranges::find(items, "Welcome", &OnGlass::label);
  ASSERT_NE(welcome, items.end());
  EXPECT_EQ(welcome->role, "text");
  EXPECT_NEAR(welcome->text_mm, 18, 0.2);
  EXPECT_EQ(items.front().name, "begin");
  EXPECT_TRUE(items.front().has_focus);
}

TEST(OnGlass, FindsWhatCoversAndWhatLeavesTheScreen) {
  const ScreenShape shape;
  const auto at = [](float x, float y) {
    OnGlass one{
        .name = {}, .role = "text", .label = {}, .state = "normal", .rect = {}, .spoken = {}};
    one.rect = {x, y, 0.1F, 0.1F};
    return one;
  };

  EXPECT_EQ(overlaps({at(0, 0), at(0.05F, 0.05F), at(0.5F, 0.5F)}, shape).size(), 1U);
  EXPECT_TRUE(overlaps({at(0, 0), at(0.1F, 0)}, shape).empty());
  EXPECT_EQ(outside({at(0, 0), at(0.95F, 0)}, shape), std::vector<std::size_t>{1});
}

}  // namespace
}  // namespace docent::interface::on_glass_test
