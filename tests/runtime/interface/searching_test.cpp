#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/interface/finder.h"
#include "runtime/interface/layout.h"
#include "runtime/interface/seats.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/runtime/interface/seen.h"
#include "tests/support/sample_museum.h"
#include "tests/support/shipped_languages.h"

namespace docent::interface::searching_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

const Museum& museum() {
  static const Museum it = [] {
    Museum all = test::in_all_shipped_languages(test::sample_museum_without_walls());
    all.connections = {{.id = "stairs", .stops = {}},
                       {.id = "escalator", .kind = ConnectionKind::Escalator, .stops = {}}};
    return all;
  }();
  return it;
}

std::unique_ptr<View> laid_out(const ViewRequest& request) {
  const SetPicture plain = [](std::uint32_t, std::uint32_t width, std::uint32_t height) {
    return Pixels{width, height,
                  std::vector<std::byte>(std::size_t{4} * width * height, std::byte{255})};
  };
  PieceCache cache({test::boxes, plain}, 1, 1 << 20);
  return make_view(museum(), request, cache);
}

std::uint32_t language_of(std::string_view tag) {
  return static_cast<std::uint32_t>(std::ranges::find(museum().languages, tag, &Language::tag) -
                                    museum().languages.begin());
}

/// Letters that find one thing, many, or nothing, or fill what is typed; none.
void type_anything(InterfaceState& state) {
  for (const char16_t letter :
       *rc::gen::element(std::u16string(), std::u16string(u"b"),
                         std::u16string(u"bronze tripod of the king"), std::u16string(u"xqzj")))
    state = after(state, {Action::Kind::Type, letter});
  static Finder finder(museum());
  finder.look_up(state);
}

/// The screen in any language, on any glass from 1024 x 768 at 15 inches to 4K, either way up.
ViewRequest any_search() {
  ViewRequest request;
  const auto shorter = *rc::gen::inRange(768U, 2161U);
  const double ratio = *rc::gen::element(4.0 / 3, 1.6, 16.0 / 9, 21.0 / 9);
  const auto longer = static_cast<std::uint32_t>(std::lround(shorter * ratio));
  const bool landscape = *rc::gen::arbitrary<bool>();
  request.shape.width = landscape ? longer : shorter;
  request.shape.height = landscape ? shorter : longer;
  request.shape.diagonal_inches = static_cast<float>(*rc::gen::inRange(24, 66));
  InterfaceState& state = request.state;
  state.language = *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum().languages.size()));
  state.large_letters = *rc::gen::inRange(0, 3) == 0;
  state.can_lower = *rc::gen::arbitrary<bool>();
  if (*rc::gen::inRange(0, 3) == 0)
    state.exhibit = *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum().exhibits.size()));
  state = after(state, {Action::Kind::Search});
  state.types_numbers = *rc::gen::inRange(0, 4) == 0;
  type_anything(state);
  state.page = *rc::gen::inRange(0U, 2U);
  return request;
}

/// The same on a card at any edge of any glass that is large enough to be shared.
ViewRequest any_search_on_a_card() {
  ViewRequest request = any_search();
  request.shape.diagonal_inches = static_cast<float>(*rc::gen::inRange(32, 86));
  request.shape.sides.bits = static_cast<std::uint8_t>(*rc::gen::inRange(1, 16));
  request.shape.text_scale = *rc::gen::element(1.0F, 1.0F, 1.4F, 2.0F);
  const std::uint32_t seats = seats_on(request.shape, *rc::gen::inRange(2U, 9U));
  RC_PRE(seats > 1);
  InterfaceState state;
  state.language = request.state.language;
  state.screen = Screen::Choosing;
  state.glass = *rc::gen::element(Glass::Busy, Glass::Full);
  state.seats = static_cast<std::uint8_t>(seats);
  state.seat = 1 + *rc::gen::inRange(0U, seats);
  state.look = *rc::gen::inRange(0U, 8U);
  state.exhibit = request.state.exhibit;
  state = after(state, {Action::Kind::Search});
  state.types_numbers = request.state.types_numbers;
  type_anything(state);
  state.page = *rc::gen::inRange(0U, 2U);
  request.state = state;
  return request;
}

/// Is there less than so much between two rectangles, in pixels?
bool within(const scene::Rect& a, const scene::Rect& b, const View& view, float pixels) {
  const float x = pixels / view.pixel_width, y = pixels / view.pixel_height;
  return a.x < b.x + b.width + x && b.x < a.x + a.width + x && a.y < b.y + b.height + y &&
         b.y < a.y + a.height + y;
}

TEST(TheSearchScreen, HasKeysOfFifteenMillimetresThreeApartInEveryLanguageOnEveryGlass) {
  EXPECT_TRUE(rc::check("inside, apart, 15 and 3 mm", [] {
    const ViewRequest request = any_search();
    const auto view = laid_out(request);
    RC_LOG() << museum().languages[request.state.language].tag << ", " << request.shape.width
             << " x " << request.shape.height << ", " << request.shape.diagonal_inches
             << " inches, large " << request.state.large_letters << "\n";
    const float mm =
        std::hypot(view->pixel_width, view->pixel_height) / (request.shape.diagonal_inches * 25.4F);
    for (std::size_t i = 0; i < view->controls.size(); ++i) {
      const Control& control = view->controls[i];
      const scene::Rect r = test::reached(*view, i);
      RC_LOG() << control.name << "\n";
      RC_ASSERT(r.x >= -1e-5F && r.y >= -1e-5F);
      RC_ASSERT(r.x + r.width <= 1.00001F && r.y + r.height <= 1.00001F);
      RC_ASSERT(r.width * view->pixel_width >= 15 * mm - 1);
      RC_ASSERT(r.height * view->pixel_height >= 15 * mm - 1);
      for (std::size_t j = 0; j < i; ++j) {
        const bool are_keys =
            control.name.starts_with("key:") && view->controls[j].name.starts_with("key:");
        // Items of a list that scrolls are each seen at another time.
        const bool are_items =
            control.role == Role::ListItem && view->controls[j].role == Role::ListItem;
        if (!are_items)
          RC_ASSERT(!within(r, test::reached(*view, j), *view, are_keys ? 3 * mm - 1 : -0.1F));
      }
    }
    RC_ASSERT(view->free.width * view->free.height >= 0.55F);
  }));
}

/// Where two controls lie when both are seen: what scrolls, as it lies at its beginning.
std::array<scene::Rect, 2> together(const View& view, std::size_t a, std::size_t b) {
  const auto lying = [&](std::size_t control) -> const scene::Rect* {
    const auto found = std::ranges::find(view.scroll.controls, static_cast<std::int32_t>(control),
                                         &ScrollArea::Scrolled::control);
    return found == view.scroll.controls.end() ? nullptr : &found->rect;
  };
  if (const auto *x = lying(a), *y = lying(b); x != nullptr && y != nullptr) return {*x, *y};
  return {test::reached(view, a), test::reached(view, b)};
}

TEST(TheSearchCard, HasKeysOfFifteenMillimetresThreeApartInEveryLanguageAtEveryEdge) {
  EXPECT_TRUE(rc::check("inside its card, apart, 15 and 3 mm", [] {
    const ViewRequest request = any_search_on_a_card();
    const auto view = laid_out(request);
    const scene::Rect card = card_of(request.shape, request.state.seats, *request.state.seat);
    const float mm =
        std::hypot(view->pixel_width, view->pixel_height) / (request.shape.diagonal_inches * 25.4F);
    RC_LOG() << museum().languages[request.state.language].tag << ", " << request.shape.width
             << " x " << request.shape.height << ", " << request.shape.diagonal_inches
             << " inches, sides " << int{request.shape.sides.bits} << ", seat "
             << *request.state.seat << " of " << int{request.state.seats} << ", letters "
             << request.shape.text_scale << ", card " << card.width * view->pixel_width / mm
             << " x " << card.height * view->pixel_height / mm << " mm\n";
    const auto is_key_at = [&](std::size_t i) { return is_key(view->controls[i]); };
    std::size_t keys = 0;
    for (std::size_t i = 0; i < view->controls.size(); ++i) {
      const scene::Rect r = test::reached(*view, i);
      RC_LOG() << view->controls[i].name << "\n";
      keys += is_key_at(i) ? 1 : 0;
      RC_ASSERT(r.x >= card.x - 1e-4F && r.x + r.width <= card.x + card.width + 1e-4F);
      RC_ASSERT(r.y >= card.y - 1e-4F && r.y + r.height <= card.y + card.height + 1e-4F);
      RC_ASSERT(r.width * view->pixel_width >= 15 * mm - 1);
      RC_ASSERT(r.height * view->pixel_height >= 15 * mm - 1);
      for (std::size_t j = 0; j < i; ++j) {
        const auto [a, b] = together(*view, i, j);
        RC_LOG() << "beside " << view->controls[j].name << "\n";
        RC_ASSERT(!within(a, b, *view, is_key_at(i) || is_key_at(j) ? 3 * mm - 1 : -0.1F));
      }
    }
    RC_ASSERT(keys >= 14);
  }));
}

TEST(TheSearchCard, SetsNoTextOverAnotherAndNoneOutsideOfItsCard) {
  EXPECT_TRUE(rc::check("in any language, in any size of letters", [] {
    const ViewRequest request = any_search_on_a_card();
    const auto view = laid_out(request);
    const scene::Rect card = card_of(request.shape, request.state.seats, *request.state.seat);
    RC_LOG() << museum().languages[request.state.language].tag << ", " << request.shape.width
             << " x " << request.shape.height << ", " << request.shape.diagonal_inches
             << " inches, sides " << int{request.shape.sides.bits} << ", seat "
             << *request.state.seat << " of " << int{request.state.seats} << ", letters "
             << request.shape.text_scale << "\n";
    std::vector<scene::Rect> texts = test::seen_texts(*view);
    for (std::size_t i = 0; i < texts.size(); ++i) {
      scene::Rect& r = texts[i];
      RC_ASSERT(r.x >= card.x - 1e-3F && r.x + r.width <= card.x + card.width + 1e-3F);
      RC_ASSERT(r.y >= card.y - 1e-3F && r.y + r.height <= card.y + card.height + 1e-3F);
      r.y += 2.1F / view->pixel_height;  // they stand on whole pixels
      r.height -= 4.2F / view->pixel_height;
      for (std::size_t j = 0; j < i; ++j) RC_ASSERT(!within(r, texts[j], *view, -0.1F));
    }
  }));
}

TEST(TheSearchCard, ShowsTheKeysWithoutScrollingOnAnOrdinaryGlass) {
  for (std::uint32_t language = 0; language < museum().languages.size(); ++language)
    for (std::uint32_t seats = 2; seats <= 4; ++seats) {
      ViewRequest request;
      request.shape = {.width = 3840, .height = 2160, .diagonal_inches = 55};
      request.shape.sides.add(scene::Side::Bottom);
      InterfaceState& state = request.state;
      state.language = language;
      state.screen = Screen::Choosing;
      state.glass = Glass::Busy;
      state.seats = static_cast<std::uint8_t>(seats);
      state.seat = 1;
      state.look = 0;
      state = after(state, {Action::Kind::Search});

      const auto view = laid_out(request);

      for (const Control& control : view->controls) {
        if (!is_key(control)) continue;
        EXPECT_GT(control.rect.width, 0)
            << museum().languages[language].tag << ", " << seats << " seats: " << control.name;
      }
    }
}

TEST(TheSearchCard, IsForWhoHasAGuideAndForgetsWithThem) {
  InterfaceState state;
  state.screen = Screen::Picking;
  state.glass = Glass::Busy;
  state.seats = 2;
  state.seat = 2;
  EXPECT_EQ(after(state, {Action::Kind::Search}), state);
  EXPECT_TRUE(touches_to(museum(), state, 6, "search", 1).empty()) << "first, by whom they are led";
  state.look = 3;
  state.screen = Screen::Choosing;
  EXPECT_EQ(touches_to(museum(), state, 6, "search").size(), 1U);

  state = after(state, {Action::Kind::Search});
  state = after(state, {Action::Kind::Type, u'b'});
  ASSERT_EQ(state.screen, Screen::Searching);
  EXPECT_EQ(state.typed.letters(), u"b");

  EXPECT_EQ(after(state, {Action::Kind::Home}).typed.count, 0);
}

TEST(TheSearchScreen, ReadsFromLeftToRightOnKeysWhereTheLanguageDoesNot) {
  ViewRequest request;
  request.state.language = language_of("ar");
  request.state = after(request.state, {Action::Kind::Search});

  const auto view = laid_out(request);

  const auto x_of = [&](std::string_view name) {
    return std::ranges::find(view->controls, name, &Control::name)->rect.x;
  };
  EXPECT_LT(x_of("key:ض"), x_of("key:ص"));
  EXPECT_LT(x_of("key:numbers"), x_of("key:clear"));
  EXPECT_GT(view->panel.x, 0.5F) << "the rest of it is turned over";
}

TEST(TheSearchScreen, IsOneTouchAwayFromWelcomeAndListAndItsKeysTwo) {
  InterfaceState list;
  list.screen = Screen::Choosing;
  for (const InterfaceState& state : {InterfaceState{}, list}) {
    EXPECT_EQ(touches_to(museum(), state, 8, "search").size(), 1U);
    EXPECT_EQ(touches_to(museum(), state, 8, "key:b").size(), 2U);
  }
  for (const char* name : {"search", "key:q", "key:7", "key:ㅎ", "key:ض", "key:space", "key:erase"})
    EXPECT_TRUE(is_control_name(museum(), name)) << name;
  EXPECT_FALSE(is_control_name(museum(), "key:?"));
}

TEST(TheSearchScreen, SaysTheLetterAndHowMuchIsFoundAndWhatEveryKeyIs) {
  ViewRequest request;
  request.state = after({}, {Action::Kind::Search});
  EXPECT_THAT(text_of(laid_out(request)->speech.opening), HasSubstr("Type a name"));
  for (const char16_t letter : std::u16string_view(u"trip"))
    request.state = after(request.state, {Action::Kind::Type, letter});
  Finder(museum()).look_up(request.state);

  const auto view = laid_out(request);

  EXPECT_EQ(text_of(view->speech.opening), "p. Found 1.");
  EXPECT_TRUE(view->speech.keeps_focus) << "the focus stays on the key";
  std::vector<std::string> said;
  for (const Utterance& control : view->speech.controls) said.push_back(text_of(control));
  EXPECT_THAT(said, Contains(HasSubstr("Bronze Tripod")));
  EXPECT_THAT(said, Contains("q. button."));
  EXPECT_THAT(said, Contains("Delete. button."));
}

TEST(TheSearchScreen, SaysNothingThatIsNotPrepared) {
  for (std::uint32_t language = 0; language < museum().languages.size(); ++language) {
    const std::vector<std::string> pieces = spoken_pieces(museum(), language);
    for (const bool numbers : {false, true})
      for (const std::u16string_view typed : {u"", u"b", u"ㅂ", u"ا", u"मक", u"12"}) {
        ViewRequest request;
        request.state.language = language;
        request.state = after(request.state, {Action::Kind::Search});
        request.state.types_numbers = numbers;
        for (const char16_t letter : typed)
          request.state = after(request.state, {Action::Kind::Type, letter});
        Finder(museum()).look_up(request.state);
        const auto controls = controls_of(museum(), request.state, 6);
        const Speech speech = speech_of(museum(), request, controls, {}, nullptr);
        std::vector<Utterance> all = speech.controls;
        all.insert(all.end(), {speech.opening, speech.help});
        for (const Utterance& said : all) {
          if (said.language != museum().languages[language].tag) continue;  // a language's name
          for (const SpokenPiece& piece : said.pieces)
            EXPECT_TRUE(std::ranges::binary_search(pieces, piece.text))
                << said.language << ": " << piece.text;
        }
      }
  }
}

}  // namespace
}  // namespace docent::interface::searching_test
