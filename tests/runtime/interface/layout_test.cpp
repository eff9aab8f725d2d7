#include "runtime/interface/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "runtime/interface/seats.h"
#include "runtime/scene/side.h"
#include "tests/runtime/interface/any_request.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/runtime/interface/seen.h"
#include "tests/support/sample_museum.h"

namespace docent::interface::layout_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

using test::boxes;

Pixels plain(std::uint32_t /*image*/, std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<std::byte>(std::size_t{4} * width * height, std::byte{255})};
}

const Museum& museum() {
  static const Museum it = [] {
    Museum museum = test::sample_museum_without_walls();
    museum.connections = {{.id = "stairs", .stops = {}},
                          {.id = "escalator", .kind = ConnectionKind::Escalator, .stops = {}}};
    add_pictures_and_more(museum);
    return museum;
  }();
  return it;
}

std::unique_ptr<View> laid_out(const ViewRequest& request) {
  PieceCache cache({boxes, plain}, 1, 1 << 20);
  return make_view(museum(), request, cache);
}

/// Any state on any screen a museum might hang up: 4:3 to 21:9, either way up, 720 lines and more,
/// 19 inches and more.
ViewRequest any_request() {
  ViewRequest request;
  const auto shorter = *rc::gen::inRange(720U, 2161U);
  const double ratio = *rc::gen::element(4.0 / 3, 1.6, 16.0 / 9, 21.0 / 9);
  const auto longer = static_cast<std::uint32_t>(std::lround(shorter * ratio));
  const bool landscape = *rc::gen::arbitrary<bool>();
  request.shape.width = landscape ? longer : shorter;
  request.shape.height = landscape ? shorter : longer;
  request.shape.diagonal_inches = static_cast<float>(*rc::gen::inRange(24, 66));
  request.state.screen =
      *rc::gen::element(Screen::Welcome, Screen::Choosing, Screen::Walking, Screen::Arrived);
  request.state.language = *rc::gen::inRange(0U, 3U);
  request.state.exhibit =
      *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum().exhibits.size()));
  if (*rc::gen::inRange(0, 4) == 0) {
    request.state.exhibit.reset();
    request.state.place = *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum().places.size()));
    request.state.seeks = PlaceKind::Toilets;
  }
  look_closer(request.state);
  request.state.lists = *rc::gen::element(Listed::Exhibits, Listed::Places, Listed::OwnTour);
  for (auto collected = *rc::gen::inRange(request.state.lists == Listed::OwnTour ? 1 : 0, 20);
       collected > 0; --collected)
    add_to(request.state.own_tour, static_cast<std::uint32_t>(collected));
  request.state.page = *rc::gen::inRange(0U, 2U);
  request.state.kind =
      *rc::gen::element(RouteKind::Shortest, RouteKind::Skeleton, RouteKind::Offset);
  if (*rc::gen::arbitrary<bool>())
    request.state.tour = TourWalk{*rc::gen::inRange(0U, 2U), *rc::gen::inRange(0U, 7U)};
  request.state.arrived = request.state.screen == Screen::Arrived;
  if (*rc::gen::arbitrary<bool>())
    request.route_summary = RouteSummary{path::RouteStatus::Ok, 42.4, 55};
  return request;
}

/// Any card of any glass that is large enough to be shared.
ViewRequest any_card() {
  ViewRequest request = any_request();
  request.shape.diagonal_inches = static_cast<float>(*rc::gen::inRange(32, 86));
  request.shape.sides.bits = static_cast<std::uint8_t>(*rc::gen::inRange(1, 16));
  const std::uint32_t seats = seats_on(request.shape, *rc::gen::inRange(2U, 9U));
  RC_PRE(seats > 1);
  request.state.screen = *rc::gen::element(Screen::Welcome, Screen::Picking, Screen::Choosing,
                                           Screen::Walking, Screen::Arrived);
  request.state.glass = *rc::gen::element(Glass::Quiet, Glass::Busy);
  request.state.seats = static_cast<std::uint8_t>(seats);
  request.state.seat = 1 + *rc::gen::inRange(0U, seats);
  request.state.taken = static_cast<std::uint8_t>(*rc::gen::inRange(0, 256));
  if (request.state.screen > Screen::Picking) request.state.look = *rc::gen::inRange(0U, 8U);
  return request;
}

bool overlap(const scene::Rect& a, const scene::Rect& b) {
  constexpr float slack = 1e-5F;
  return a.x + slack < b.x + b.width && b.x + slack < a.x + a.width &&
         a.y + slack < b.y + b.height && b.y + slack < a.y + a.height;
}

TEST(Layout, PutsEveryControlOnTheScreenAndApartFromAllOthers) {
  EXPECT_TRUE(rc::check("inside and apart", [] {
    const auto view = laid_out(any_request());
    for (std::size_t i = 0; i < view->controls.size(); ++i) {
      const Control& control = view->controls[i];
      if (control.role == Role::Spot) continue;
      const scene::Rect r = test::reached(*view, i);
      RC_ASSERT(r.width > 0 && r.height > 0);
      RC_ASSERT(r.x >= 0 && r.y >= 0 && r.x + r.width <= 1.00001F && r.y + r.height <= 1.00001F);
      for (std::size_t j = 0; j < i; ++j)
        if (view->controls[j].role != Role::Spot)
          RC_ASSERT(!overlap(control.rect, view->controls[j].rect));
    }
  }));
}

TEST(Layout, MakesEveryTargetAtLeastFifteenMillimetres) {
  EXPECT_TRUE(rc::check("a fingertip fits", [] {
    const ViewRequest request = any_request();
    const auto view = laid_out(request);
    const float pixels = std::hypot(view->pixel_width, view->pixel_height);
    const float mm = pixels / (request.shape.diagonal_inches * 25.4F);
    for (std::size_t i = 0; i < view->controls.size(); ++i) {
      if (view->controls[i].role == Role::Spot) continue;
      const scene::Rect rect = test::reached(*view, i);
      RC_ASSERT(rect.height * view->pixel_height >= 15 * mm - 1);
      RC_ASSERT(rect.width * view->pixel_width >= 15 * mm - 1);
    }
    RC_ASSERT(view->spot_px >= 15 * mm - 1);
  }));
}

TEST(Layout, LeavesTheModelMostOfTheScreen) {
  EXPECT_TRUE(rc::check("at least 55 %", [] {
    const auto view = laid_out(any_request());
    RC_ASSERT(view->free.width * view->free.height >= 0.55F);
    RC_ASSERT(!overlap(view->free, view->panel));
  }));
}

/// The controls whose place does not depend on what there is to scroll.
std::set<std::string> names_of(const View& view) {
  std::set<std::string> names;
  for (const Control& control : view.controls)
    if (control.action.kind != Action::Kind::Scroll) names.insert(control.name);
  return names;
}

TEST(Layout, IsMirroredInArabic) {
  EXPECT_TRUE(rc::check("the panel changes sides, and nothing is lost", [] {
    ViewRequest request = any_request();
    request.state.language = 0;
    const auto english = laid_out(request);
    request.state.language = 2;
    const auto arabic = laid_out(request);
    RC_ASSERT(names_of(*english) == names_of(*arabic));
    RC_ASSERT(std::abs(arabic->panel.x - (1 - english->panel.x - english->panel.width)) < 1e-5F);
    for (const Control& e : english->controls) {
      const auto a = std::ranges::find_if(arabic->controls, [&](const Control& control) {
        return control.name == e.name && control.role == e.role;
      });
      if (e.role == Role::Spot || a == arabic->controls.end() || a->rect.width <= 0) continue;
      if (e.rect.width <= 0) continue;
      const auto in_panel = [](const Control& control, const View& view) {
        return scene::contains(view.panel, control.rect.x + control.rect.width / 2,
                               control.rect.y + control.rect.height / 2);
      };
      RC_ASSERT(in_panel(e, *english) == in_panel(*a, *arabic));
    }
  }));
}

TEST(Layout, BeginsLinesAtTheRightInArabic) {
  ViewRequest request;
  const auto english = laid_out(request);
  request.state.language = 2;
  const auto arabic = laid_out(request);

  const Control &e = english->controls.front(), &a = arabic->controls.front();
  ASSERT_EQ(e.name, "begin");
  EXPECT_NEAR(a.rect.x, 1 - e.rect.x - e.rect.width, 1e-5F);
}

TEST(Layout, SetsTextOnWholePixels) {
  EXPECT_TRUE(rc::check("texel for pixel", [] {
    const auto view = laid_out(any_request());
    for (const Element& element : view->elements) {
      if (element.quad.fill != scene::QuadFill::Text) continue;
      const float x = element.quad.rect.x * view->pixel_width;
      const float y = element.quad.rect.y * view->pixel_height;
      RC_ASSERT(std::abs(x - std::round(x)) < 0.02F);
      RC_ASSERT(std::abs(y - std::round(y)) < 0.02F);
    }
  }));
}

TEST(Card, KeepsItsControlsApartAndFingertipsWide) {
  EXPECT_TRUE(rc::check("inside, apart, 15 mm", [] {
    const ViewRequest request = any_card();
    const auto view = laid_out(request);
    const scene::Rect card = card_of(request.shape, request.state.seats, *request.state.seat);
    const float mm =
        std::hypot(view->pixel_width, view->pixel_height) / (request.shape.diagonal_inches * 25.4F);
    for (std::size_t i = 0; i < view->controls.size(); ++i) {
      const Control& control = view->controls[i];
      const scene::Rect r = test::reached(*view, i);
      if (!control.enabled && r.width <= 0) continue;
      RC_ASSERT(r.x >= card.x - 1e-4F && r.x + r.width <= card.x + card.width + 1e-4F);
      RC_ASSERT(r.y >= card.y - 1e-4F && r.y + r.height <= card.y + card.height + 1e-4F);
      RC_ASSERT(r.width * view->pixel_width >= 15 * mm - 1);
      RC_ASSERT(r.height * view->pixel_height >= 15 * mm - 1);
      for (std::size_t j = 0; j < i; ++j) RC_ASSERT(!overlap(control.rect, view->controls[j].rect));
    }
  }));
}

TEST(Card, KeepsItsTextsInside) {
  EXPECT_TRUE(rc::check("no text leaves its card", [] {
    const ViewRequest request = any_card();
    const auto view = laid_out(request);
    const scene::Rect card = card_of(request.shape, request.state.seats, *request.state.seat);
    for (const scene::Rect& r : test::seen_texts(*view)) {
      RC_ASSERT(r.x >= card.x - 1e-3F && r.x + r.width <= card.x + card.width + 1e-3F);
      RC_ASSERT(r.y >= card.y - 1e-3F && r.y + r.height <= card.y + card.height + 1e-3F);
    }
  }));
}

TEST(Card, SetsNoTextOverAnother) {
  EXPECT_TRUE(rc::check("in any language, in any size of letters", [] {
    ViewRequest request = any_card();
    request.shape.text_scale = *rc::gen::element(1.0F, 1.4F, 2.0F);
    request.state.seats = static_cast<std::uint8_t>(seats_on(request.shape, request.state.seats));
    RC_PRE(request.state.seats > 1);
    request.state.seat = 1 + *request.state.seat % request.state.seats;
    const auto view = laid_out(request);
    const std::vector<scene::Rect> texts = test::seen_texts(*view);
    RC_LOG() << "screen " << static_cast<int>(request.state.screen) << ", language "
             << request.state.language << ", letters " << request.shape.text_scale << ", "
             << request.shape.width << " x " << request.shape.height << ", "
             << request.shape.diagonal_inches << " inches, " << int{request.state.seats}
             << " seats\n";
    for (std::size_t i = 0; i < texts.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        scene::Rect text = texts[i];
        text.y += 2.1F / view->pixel_height;  // they stand on whole pixels
        text.height -= 4.2F / view->pixel_height;
        RC_ASSERT(!overlap(text, texts[j]));
      }
  }));
}

/// Each side as one sees it who stands there.
scene::Rect whole_of(const ScreenShape& shape, std::uint32_t seats, std::uint32_t seat) {
  return scene::to_screen(side_of(shape, seats, seat), card_of(shape, seats, seat));
}

TEST(Card, LiesApartFromAllOthersAndFromTheModel) {
  EXPECT_TRUE(rc::check("on every side of any glass", [] {
    const ViewRequest request = any_card();
    const ScreenShape& shape = request.shape;
    const std::uint32_t seats = request.state.seats;
    std::set<scene::Side> sides;
    for (std::uint32_t seat = 1; seat <= seats; ++seat) {
      const scene::Rect card = whole_of(shape, seats, seat);
      sides.insert(side_of(shape, seats, seat));
      RC_ASSERT(card.x >= 0 && card.y >= 0);
      RC_ASSERT(card.x + card.width <= 1.0001F && card.y + card.height <= 1.0001F);
      RC_ASSERT(!overlap(card, model_of(shape)));
      for (std::uint32_t other = 1; other < seat; ++other)
        RC_ASSERT(!overlap(card, whole_of(shape, seats, other)));
    }
    for (const scene::Side side : sides) RC_ASSERT(shape.sides.has(side));
  }));
}

/// A glass that has become smaller keeps its seats.
TEST(Card, LiesWherePeopleStandEvenWhereThereIsNoRoomForAll) {
  EXPECT_TRUE(rc::check("more seats than room", [] {
    const ScreenShape shape = any_card().shape;
    for (std::uint32_t seat = 1; seat <= most_seats; ++seat)
      RC_ASSERT(shape.sides.has(side_of(shape, most_seats, seat)));
  }));
}

/// Letters as boxes; those of Arabic are three quarters as wide as others.
TextBitmap narrow_arabic(const TextStyle& style, std::string_view text, std::uint32_t width) {
  const float narrower = style.right_to_left ? 0.75F : 1;
  TextBitmap set =
      boxes(style, text, static_cast<std::uint32_t>(static_cast<float>(width) / narrower));
  set.width = static_cast<std::uint32_t>(std::ceil(static_cast<float>(set.width) * narrower));
  set.coverage.assign(std::size_t{set.width} * set.height, 255);
  return set;
}

std::unique_ptr<View> laid_out_as_set(const ViewRequest& request) {
  PieceCache cache({narrow_arabic, plain}, 1, 1 << 20);
  return make_view(museum(), request, cache);
}

/// Whatever staff may write into kiosk.toml of a glass that is shared.
ViewRequest any_shared_list() {
  ViewRequest request;
  constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 3> sizes{
      {{3840, 2160}, {1920, 1200}, {1280, 720}}};
  const auto [longer, shorter] = *rc::gen::elementOf(sizes);
  const bool is_upright = *rc::gen::arbitrary<bool>();
  request.shape.width = is_upright ? shorter : longer;
  request.shape.height = is_upright ? longer : shorter;
  request.shape.diagonal_inches = static_cast<float>(*rc::gen::inRange(32, 66));
  request.shape.text_scale = *rc::gen::element(1.0F, 1.0F, 1.5F, 2.0F);
  request.shape.sides.bits = static_cast<std::uint8_t>(*rc::gen::inRange(1, 16));
  const std::uint32_t seats = seats_on(request.shape, *rc::gen::inRange(1U, 9U));
  RC_PRE(seats > 1);
  request.state.screen = Screen::Choosing;
  request.state.glass = Glass::Busy;
  request.state.seats = static_cast<std::uint8_t>(seats);
  request.state.seat = 1 + *rc::gen::inRange(0U, seats);
  request.state.look = 1;
  request.state.language = *rc::gen::inRange(0U, 3U);
  request.state.lists = *rc::gen::element(Listed::Exhibits, Listed::Places, Listed::OwnTour);
  for (std::uint32_t i = 0; i < 9; ++i) add_to(request.state.own_tour, i);
  if (*rc::gen::arbitrary<bool>()) request.state.exhibit = 2;
  return request;
}

TEST(Card, ShowsSixRowsOfTheListOnAnyGlassThatIsShared) {
  EXPECT_TRUE(rc::check("32 to 65 inches, any sides, any number of visitors", [] {
    const ViewRequest request = any_shared_list();
    const auto view = laid_out_as_set(request);
    const auto items = static_cast<std::size_t>(
        std::ranges::count(view->controls, Role::ListItem, &Control::role));
    const std::size_t seen = test::whole_items(*view);
    RC_LOG() << seen << " of " << items << " items, " << request.shape.width << " x "
             << request.shape.height << ", " << request.shape.diagonal_inches << " inches, letters "
             << request.shape.text_scale << ", sides " << int{request.shape.sides.bits} << ", seat "
             << *request.state.seat << " of " << int{request.state.seats} << ", language "
             << request.state.language << ", list " << static_cast<int>(request.state.lists)
             << '\n';
    RC_ASSERT(seen >= std::min<std::size_t>(6, items));
    const scene::Rect card = card_of(request.shape, request.state.seats, *request.state.seat);
    RC_ASSERT(card.x >= 0 && card.y >= 0 && card.x + card.width <= 1.0001F &&
              card.y + card.height <= 1.0001F);
    for (std::size_t i = 0; i < view->controls.size(); ++i) {
      const scene::Rect r = test::reached(*view, i);
      RC_ASSERT(r.width > 0 && r.height > 0);
      RC_ASSERT(r.x >= card.x - 1e-4F && r.x + r.width <= card.x + card.width + 1e-4F);
      RC_ASSERT(r.y >= card.y - 1e-4F && r.y + r.height <= card.y + card.height + 1e-4F);
      for (std::size_t j = 0; j < i; ++j)
        RC_ASSERT(!overlap(view->controls[i].rect, view->controls[j].rect));
    }
  }));
}

TEST(Card, HasSixRowsOfTheListAndLettersOfFiveMillimetres) {
  EXPECT_TRUE(rc::check("six items a page", [] {
    ViewRequest request = any_card();
    request.state.screen = Screen::Choosing;
    request.state.lists = Listed::Exhibits;
    request.state.page = 0;
    const auto view = laid_out(request);
    const auto items = std::ranges::count_if(
        view->controls, [](const Control& control) { return control.role == Role::ListItem; });
    RC_LOG() << items << " items, " << request.shape.width << " x " << request.shape.height << ", "
             << request.shape.diagonal_inches << " inches, sides " << int{request.shape.sides.bits}
             << '\n';
    RC_ASSERT(items >= 6);
    const float mm =
        std::hypot(view->pixel_width, view->pixel_height) / (request.shape.diagonal_inches * 25.4F);
    for (const Words& words : view->words)
      RC_ASSERT(words.capitals_px >= 5 * mm - 0.8F);  // in whole pixels, rounded twice
  }));
}

TEST(Card, ShowsTheGoalAndTheWayThereAndLeavesTheModelToAll) {
  ViewRequest request;
  request.shape = {.width = 3840, .height = 2160, .diagonal_inches = 55};
  for (const scene::Side side : scene::all_sides) request.shape.sides.add(side);
  request.state.screen = Screen::Walking;
  request.state.glass = Glass::Busy;
  request.state.seats = 8;
  request.state.look = 1;
  request.state.exhibit = 2;
  const ShownWay way{.directions = {}, .line = {{20, 3}, {20, 12}}};
  for (std::uint32_t seat = 1; seat <= 8; ++seat) {
    request.state.seat = seat;
    PieceCache cache({boxes, plain}, 1, 1 << 20);

    const auto view = make_view(museum(), request, cache, {}, &way);

    const scene::Rect card = card_of(request.shape, 8, seat);
    EXPECT_EQ(view->side, side_of(request.shape, 8, seat));
    EXPECT_GT(view->inset.board.width, 0) << seat;
    EXPECT_GE(view->inset.board.x, card.x) << seat;
    const auto picture = std::ranges::find_if(view->elements, [&](const Element& element) {
      return element.quad.fill == scene::QuadFill::Image &&
             element.quad.rect.height > 0.3F * card.height;
    });
    EXPECT_NE(picture, view->elements.end()) << seat;
    EXPECT_TRUE(view->labels.empty());
  }
}

TEST(Card, IsTurnedOverInArabicAndStaysWhereItIs) {
  ViewRequest request;
  request.shape = {.width = 3840, .height = 2160, .diagonal_inches = 65};
  request.state.screen = Screen::Choosing;
  request.state.glass = Glass::Busy;
  request.state.seats = 4;
  request.state.seat = 2;
  request.state.look = 1;
  const auto english = laid_out(request);
  request.state.language = 2;
  const auto arabic = laid_out(request);
  const scene::Rect card = card_of(request.shape, request.state.seats, *request.state.seat);

  EXPECT_EQ(names_of(*english), names_of(*arabic));
  const auto help = [](const View& view) {
    return std::ranges::find(view.controls, "toilets", &Control::name)->rect;
  };
  const scene::Rect e = help(*english), a = help(*arabic);
  EXPECT_NEAR(a.x, 2 * card.x + card.width - e.x - e.width, 1e-5F);
}

/// All that is written on the glass.
std::vector<std::string> texts_of(const ViewRequest& request, const Closures& closed) {
  std::vector<std::string> texts;
  const SetText note = [&](const TextStyle& style, std::string_view text, std::uint32_t width) {
    texts.emplace_back(text);
    return boxes(style, text, width);
  };
  PieceCache cache({note, plain}, 1, 1 << 20);
  make_view(museum(), request, cache, closed);
  return texts;
}

TEST(ANumberOnTheModel, CannotBeTakenForAnotherByWhoStandsAtAnotherSide) {
  ViewRequest request;
  request.shape = {.width = 3840, .height = 2160, .diagonal_inches = 55};
  request.state.screen = Screen::Choosing;
  request.state.glass = Glass::Busy;
  request.state.seats = 8;
  ASSERT_GE(museum().exhibits.size(), 19U);
  for (const scene::Side side : {scene::Side::Bottom, scene::Side::Top}) {
    request.shape.sides.add(side);
    const bool is_turned = request.shape.sides.count() > 1;

    const std::vector<std::string> texts = texts_of(request, {});

    for (const char* marked : {"6\u0332", "9\u0332", "1\u03326\u0332", "1\u03329\u0332"})
      EXPECT_EQ(std::ranges::count(texts, marked), is_turned ? 1 : 0) << marked;
    for (const char* plain : {"1", "2", "8", "10", "11", "12"})
      EXPECT_EQ(std::ranges::count(texts, plain), 1) << plain;
    const auto view = laid_out(request);
    for (const Words& words : view->words)
      EXPECT_EQ(words.text.find("\u0332"), std::string::npos) << words.text;
  }
}

/// The first exhibit, until five in the afternoon.
Closures first_closed() {
  const std::chrono::local_days day = std::chrono::local_days(std::chrono::year(2026) / 11 / 26);
  Closures closed;
  closed.exhibits = {{0, day + std::chrono::hours(17), {{"en", "It is cleaned."}}}};
  closed.day = day;
  return closed;
}

TEST(AClosedExhibit, SaysUntilWhenInTheListAndOnACard) {
  ViewRequest request;
  request.state.screen = Screen::Choosing;
  request.state.page = static_cast<std::uint32_t>(museum().tours.size()) /
                       exhibits_per_page(request.shape, request.state);

  EXPECT_THAT(texts_of(request, first_closed()), Contains(HasSubstr("Closed until 5 p.m.")));
  EXPECT_THAT(texts_of(request, {}), Not(Contains(HasSubstr("Closed"))));

  request.shape = {.width = 3840, .height = 2160, .diagonal_inches = 65};
  request.state.seats = 4;
  request.state.seat = 1;
  request.state.glass = Glass::Busy;
  request.state.page = static_cast<std::uint32_t>(museum().tours.size()) /
                       exhibits_per_page(request.shape, request.state);

  EXPECT_THAT(texts_of(request, first_closed()), Contains(HasSubstr("Closed until 5 p.m.")));
}

TEST(LeafingThroughPictures, DecodesTheOneThatIsSeenAloneAndLeavesTheButtonsInPlace) {
  Museum shown = museum();
  shown.pictures.clear();
  std::vector<std::uint32_t> images{shown.exhibits[0].image};
  for (std::uint32_t i = 1; i < 4; ++i) {  // of different shapes, with captions of any length
    images.push_back(static_cast<std::uint32_t>(shown.images.size()));
    shown.images.push_back(
        {.name = "further", .width = 400 + 300 * i, .height = 1600 - 300 * i, .bytes = {}});
    shown.pictures.push_back(
        {.exhibit = 0, .image = images.back(), .caption = shown.exhibits[i].text});
  }
  ViewRequest request;
  request.state.screen = Screen::Arrived;
  request.state.arrived = true;
  request.state.exhibit = 0;
  for (const bool is_upright : {false, true}) {
    request.shape.width = is_upright ? 1080 : 1920;
    request.shape.height = is_upright ? 1920 : 1080;
    std::set<std::pair<float, float>> places;
    for (std::uint8_t picture = 0; picture < 4; ++picture) {
      request.state.picture = picture;
      std::set<std::uint32_t> decoded;
      const auto note = [&](std::uint32_t image, std::uint32_t width, std::uint32_t height) {
        decoded.insert(image);
        return plain(image, width, height);
      };
      PieceCache cache({boxes, note}, 1, 1 << 20);
      const auto view = make_view(shown, request, cache);
      const auto next = std::ranges::find(view->controls, "picture:next", &Control::name);
      ASSERT_NE(next, view->controls.end());
      places.emplace(next->rect.x, next->rect.y);

      for (std::uint8_t other = 0; other < 4; ++other) {
        if (other == picture) continue;
        EXPECT_THAT(decoded, Not(Contains(images[other]))) << "beside picture " << int{picture};
      }
      EXPECT_THAT(decoded, Contains(images[picture]));
    }
    EXPECT_EQ(places.size(), 1U) << "a finger can stay where it is";
  }
}

TEST(AnExhibitWithoutAPicture, IsDescribedWhereThePictureWouldBe) {
  Museum described = museum();
  described.exhibits[0].description = {{"en", "A red jar with two handles."}};
  ViewRequest request;
  request.state.screen = Screen::Arrived;
  request.state.arrived = true;
  request.state.exhibit = 0;
  const auto texts = [&] {
    std::vector<std::string> all;
    const SetText note = [&](const TextStyle& style, std::string_view text, std::uint32_t width) {
      all.emplace_back(text);
      return boxes(style, text, width);
    };
    PieceCache cache({note, plain}, 1, 1 << 20);
    make_view(described, request, cache);
    return all;
  };

  EXPECT_THAT(texts(), Not(Contains(HasSubstr("A red jar")))) << "its picture is seen";
  described.images[described.exhibits[0].image].name.clear();
  EXPECT_THAT(texts(), Contains(HasSubstr("A red jar")));
}

TEST(AnExhibitToTouch, SaysSoToWhoHasArrivedOnTheWholeGlassAndOnACard) {
  Museum touched = museum();
  touched.exhibits[0].place = ExhibitPlace::OnWallToTouch;
  for (const std::optional<std::uint32_t> seat : {std::optional<std::uint32_t>{}, {1}})
    for (const bool arrived : {false, true}) {
      ViewRequest request;
      request.shape = {.width = 1920, .height = 1080, .diagonal_inches = 55};
      request.state.screen = arrived ? Screen::Arrived : Screen::Walking;
      request.state.arrived = arrived;
      request.state.exhibit = 0;
      request.state.seat = seat;
      request.state.seats = seat ? 2 : 0;
      request.state.glass = seat ? Glass::Busy : Glass::Whole;
      std::vector<std::string> all;
      const SetText note = [&](const TextStyle& style, std::string_view text, std::uint32_t width) {
        all.emplace_back(text);
        return boxes(style, text, width);
      };
      PieceCache cache({note, plain}, 1, 1 << 20);
      make_view(touched, request, cache);
      EXPECT_EQ(std::ranges::any_of(all,
                                    [](const std::string& text) {
                                      return text.find("You may touch this one.") !=
                                             std::string::npos;
                                    }),
                arrived)
          << (seat ? "on a card" : "on the whole glass");
    }
}

TEST(AClosedExhibit, HasANumberOnTheModelThatIsUnlikeAnyOther) {
  ViewRequest request;
  request.state.screen = Screen::Choosing;
  PieceCache cache({boxes, plain}, 1, 1 << 20);

  const auto view = make_view(museum(), request, cache, first_closed());

  std::size_t closed = 0, open = 0;
  for (const FloorLabel& label : view->labels) {
    if (!label.on_disc) continue;
    const Action& action = view->controls[static_cast<std::size_t>(label.control)].action;
    EXPECT_EQ(label.is_closed, action.argument == 0);
    ++(label.is_closed ? closed : open);
  }
  EXPECT_EQ(closed, 1U);
  EXPECT_GT(open, 1U);
}

TEST(AClosedExhibit, SaysWhyWhereItIsChosenAllTheSame) {
  ViewRequest request;
  request.state.screen = Screen::Walking;
  request.state.exhibit = 0;
  request.route_summary =
      RouteSummary{.status = path::RouteStatus::GoalBlocked, .hindrance = Hindrance::Exhibit};

  const std::vector<std::string> texts = texts_of(request, first_closed());

  EXPECT_THAT(texts, Contains("Closed until 5 p.m."));
  EXPECT_THAT(texts, Contains("It is cleaned."));
  EXPECT_THAT(texts_of(request, {}), Not(Contains(HasSubstr("Closed")))) << "it has just opened";
}

TEST(Layout, CountsTheRemainingMetresDownToNearlyThere) {
  ViewRequest request;
  request.state.screen = Screen::Walking;
  request.state.exhibit = 2;
  request.route_summary = RouteSummary{path::RouteStatus::Ok, 42.4, 55};

  const auto view = laid_out(request);

  ASSERT_GT(view->remaining.size(), 10U);
  EXPECT_TRUE(std::ranges::is_sorted(view->remaining, {}, &CountedText::metres));
  EXPECT_GT(view->remaining.back().metres, 1e6F);
}

TEST(PieceCache, SetsATextOnce) {
  int set = 0;
  PieceCache cache({[&](const TextStyle& style, std::string_view text, std::uint32_t width) {
                      ++set;
                      return boxes(style, text, width);
                    },
                    plain},
                   100, 1 << 20);

  const TextPiece first = cache.text({}, "bronze", 300);
  const TextPiece again = cache.text({}, "bronze", 300);
  cache.text({}, "jade", 300);

  EXPECT_EQ(first.texture, again.texture);
  EXPECT_EQ(set, 2);
  EXPECT_EQ(cache.end_view()->uploads.size(), 2U);
  EXPECT_EQ(cache.end_view(), nullptr);
}

TEST(PieceCache, MakesAPictureOnceForEachSizeInWhichItIsDrawn) {
  PieceCache cache({boxes, plain}, 100, 1 << 20);

  const scene::TextureId card = cache.picture(7, 40, 30);
  const scene::TextureId again = cache.picture(7, 40, 30);
  const scene::TextureId large = cache.picture(7, 80, 60);
  const scene::TextureId other = cache.picture(8, 40, 30);

  EXPECT_EQ(card, again);
  EXPECT_EQ((std::set{card, large, other}.size()), 3U);
  const auto changes = cache.end_view();
  ASSERT_EQ(changes->uploads.size(), 3U);
  EXPECT_EQ(changes->uploads[1].texture, large);
  EXPECT_EQ(changes->uploads[1].picture.width, 80U);
}

TEST(PieceCache, LeavesOutAPictureThatCannotBeMade) {
  PieceCache cache({boxes, [](std::uint32_t, std::uint32_t, std::uint32_t) { return Pixels{}; }},
                   100, 1 << 20);

  EXPECT_EQ(cache.picture(0, 40, 30), scene::TextureId::None);
  EXPECT_EQ(cache.end_view(), nullptr);
}

TEST(PieceCache, RetiresOnlyWhatTheLastViewsDidNotUse) {
  PieceCache cache({boxes, plain}, 100, 1000);  // room for next to nothing
  const scene::TextureId text = cache.text({}, "once", 300).texture;
  const scene::TextureId picture = cache.picture(1, 40, 30);
  std::vector<scene::TextureId> retired;
  for (int view = 0; view < 8; ++view) {
    cache.text({}, "always", 300);
    cache.picture(2, 40, 30);
    if (const auto changes = cache.end_view())
      retired.insert(retired.end(), changes->retired.begin(), changes->retired.end());
  }

  std::ranges::sort(retired);
  EXPECT_EQ(retired, (std::vector{text, picture}));
}

TEST(PieceCache, KeepsWhatAnotherPartOfTheGlassStillShows) {
  PieceCache cache({boxes, plain}, 100, 1000);
  const scene::TextureId shown = cache.picture(1, 40, 30);
  cache.end_view(3);
  std::vector<scene::TextureId> retired;
  const auto end = [&](std::uint32_t part) {
    if (const auto changes = cache.end_view(part))
      retired.insert(retired.end(), changes->retired.begin(), changes->retired.end());
  };
  for (std::uint32_t view = 0; view < 20; ++view) {
    cache.picture(2 + view, 40, 30);
    end(1);
  }
  EXPECT_FALSE(std::ranges::any_of(retired, [&](scene::TextureId t) { return t == shown; }));

  for (int view = 0; view < 8; ++view) end(3);  // it shows something else by now
  EXPECT_TRUE(std::ranges::any_of(retired, [&](scene::TextureId t) { return t == shown; }));
}

TEST(PieceCache, StaysWithinItsBudgetAndTheLastViewsHoweverManyExhibitsAreSeen) {
  constexpr std::size_t budget = 20'000, bytes = std::size_t{4} * 40 * 30;
  PieceCache cache({boxes, plain}, 1, budget);
  std::size_t held = 0, most = 0;
  for (std::uint32_t exhibit = 0; exhibit < 500; ++exhibit) {
    cache.picture(exhibit, 40, 30);
    const auto changes = cache.end_view();
    held += changes->uploads.size() * bytes;
    held -= changes->retired.size() * bytes;
    most = std::max(most, held);
  }

  EXPECT_LE(most, budget + 4 * bytes);
}

TEST(PieceCache, RetiresWhatWasUsedLongestAgoAndNoMoreThanItMust) {
  PieceCache cache({boxes, plain}, 1, 64'000);  // 8 pictures of 40 by 30
  std::vector<scene::TextureId> shown, retired;
  for (std::uint32_t exhibit = 0; exhibit < 12; ++exhibit) {
    shown.push_back(cache.picture(exhibit, 40, 30));
    const auto changes = cache.end_view();
    retired.insert(retired.end(), changes->retired.begin(), changes->retired.end());
  }

  EXPECT_EQ(retired, (std::vector{shown[0], shown[1], shown[2], shown[3]}));
}

TEST(PieceCache, CountsWhatATextTakesInTextureMemoryAndNotItsLettersAlone) {
  constexpr std::size_t budget = 100'000, least = 2048;  // of any texture
  TextStyle small;
  small.size = 2;
  PieceCache cache({boxes, plain}, 1, budget);
  std::size_t held = 0;
  for (int number = 0; number < 500; ++number) {
    cache.text(small, std::to_string(number), 300);
    const auto changes = cache.end_view();
    held += changes->uploads.size();
    held -= changes->retired.size();
  }

  EXPECT_LE(held, budget / least);
}

TEST(View, DrawsItsPicturesTexelForPixel) {
  ViewRequest request;
  request.state.screen = Screen::Choosing;
  request.shape.width = 1366;
  request.shape.height = 768;
  PieceCache cache({boxes, plain}, 1, 1 << 20);

  const auto view = make_view(museum(), request, cache);
  const auto changes = cache.end_view();

  std::size_t pictures = 0;
  for (const Element& element : view->elements) {
    const scene::Quad& quad = element.quad;
    if (quad.fill != scene::QuadFill::Image) continue;
    ++pictures;
    const auto upload = std::ranges::find(changes->uploads, quad.texture, &PieceUpload::texture);
    ASSERT_NE(upload, changes->uploads.end());
    EXPECT_NEAR(quad.rect.width * 1366, upload->picture.width, 0.01);
    EXPECT_NEAR(quad.rect.height * 768, upload->picture.height, 0.01);
    EXPECT_NEAR(quad.rect.x * 1366, std::round(quad.rect.x * 1366), 0.01);
    EXPECT_NEAR(quad.rect.y * 768, std::round(quad.rect.y * 768), 0.01);
  }
  EXPECT_GE(pictures, 4U);
}

}  // namespace
}  // namespace docent::interface::layout_test
