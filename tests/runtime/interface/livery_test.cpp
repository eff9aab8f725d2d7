#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <vector>

#include "runtime/interface/layout.h"
#include "tests/runtime/interface/any_request.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/runtime/interface/seen.h"
#include "tests/support/sample_museum.h"

/// A museum's own look on its screens.
namespace docent::interface::livery_test {
namespace {

Pixels plain(std::uint32_t /*image*/, std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<std::byte>(std::size_t{4} * width * height, std::byte{255})};
}

/// With a logo of that shape.
Museum museum_with_logo(std::uint32_t width, std::uint32_t height) {
  Museum museum = test::sample_museum_without_walls();
  museum.livery.logo = static_cast<std::uint32_t>(museum.images.size());
  museum.images.push_back({.name = "logo.png", .width = width, .height = height, .bytes = {}});
  return museum;
}

ViewRequest welcome(std::uint32_t width, std::uint32_t height) {
  ViewRequest request;
  request.shape.width = width;
  request.shape.height = height;
  request.shape.diagonal_inches = 32;
  request.state.screen = Screen::Welcome;
  return request;
}

std::unique_ptr<View> view_of(const Museum& museum, const ViewRequest& request) {
  PieceCache cache({test::boxes, plain}, 1, 1 << 20);
  return make_view(museum, request, cache);
}

/// The pictures of a view that are no controls.
std::vector<scene::Quad> pictures(const View& view) {
  std::vector<scene::Quad> found;
  for (const Element& element : view.elements)
    if (element.quad.fill == scene::QuadFill::Image && element.greets)
      found.push_back(element.quad);
  return found;
}

/// In pixels.
double shape_of(const scene::Quad& quad, const ViewRequest& request) {
  return quad.rect.width * static_cast<float>(request.shape.width) /
         (quad.rect.height * static_cast<float>(request.shape.height));
}

bool overlap(const scene::Rect& a, const scene::Rect& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

TEST(AMuseumsLogo, IsOnTheWelcomeScreenInItsOwnShape) {
  for (const auto& [width, height] : {std::pair{768U, 100U}, {500U, 500U}, {120U, 768U}})
    for (const std::uint32_t language : {0U, 2U})
      for (const bool is_portrait : {false, true}) {
        const Museum museum = museum_with_logo(width, height);
        ViewRequest request = is_portrait ? welcome(1080, 1920) : welcome(1920, 1080);
        request.state.language = language;
        const auto view = view_of(museum, request);

        ASSERT_EQ(pictures(*view).size(), 1U) << width;
        const scene::Quad logo = pictures(*view)[0];
        EXPECT_NEAR(std::log(shape_of(logo, request)), std::log(double(width) / height), 0.05);
        for (const scene::Rect& text : test::seen_texts(*view))
          EXPECT_FALSE(overlap(text, logo.rect));
        for (const Control& control : view->controls)
          EXPECT_FALSE(overlap(control.rect, logo.rect)) << control.name;
      }
}

TEST(AMuseumsLogo, GivesWayWhereThereIsNoRoom) {
  const Museum museum = museum_with_logo(500, 500);
  ViewRequest request = welcome(1024, 768);
  request.shape.diagonal_inches = 15;
  request.shape.text_scale = 1.5F;
  const auto view = view_of(museum, request);
  EXPECT_TRUE(pictures(*view).empty());
}

TEST(AMuseumsLogo, LiesOnPaperOfTheDayWhereTheNightWouldHideIt) {
  Museum museum = museum_with_logo(500, 500);
  ViewRequest request = welcome(1920, 1080);
  request.shape.is_night = true;
  const auto ground = [&] {
    const auto view = view_of(museum, request);
    const scene::Rect logo = pictures(*view).at(0).rect;
    return std::ranges::any_of(view->elements, [&](const Element& element) {
      return element.quad.fill == scene::QuadFill::Solid &&
             element.quad.colour == scene::srgb(museum.livery.paper) &&
             element.quad.rect.x < logo.x && overlap(element.quad.rect, logo);
    });
  };
  EXPECT_TRUE(ground());
  museum.livery.logo_shows_at_night = true;
  EXPECT_FALSE(ground());
  museum.livery.logo_shows_at_night = false;
  museum.livery.logo_at_night = museum.livery.logo;
  EXPECT_FALSE(ground());
}

TEST(AMuseumsColours, AreThoseOfEveryScreen) {
  Museum museum = test::sample_museum_without_walls();
  museum.livery.paper = 0xE6EEF6;
  museum.livery.ink = 0x0A1F44;
  const Livery house;
  for (const Screen screen :
       {Screen::Welcome, Screen::Choosing, Screen::Walking, Screen::Arrived}) {
    ViewRequest request = welcome(1920, 1080);
    request.state.screen = screen;
    request.state.exhibit = 3;
    bool has_own = false;
    const auto view = view_of(museum, request);
    for (const Element& element : view->elements) {
      if (element.quad.fill == scene::QuadFill::Shadow) continue;  // no light is as it is anywhere
      const std::uint32_t colour = scene::hex_of(element.quad.colour);
      EXPECT_NE(colour, house.paper);
      EXPECT_NE(colour, house.ink);
      has_own |= colour == museum.livery.ink;
    }
    EXPECT_TRUE(has_own);
  }
}

}  // namespace
}  // namespace docent::interface::livery_test
