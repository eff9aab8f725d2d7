#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "runtime/interface/finder.h"
#include "runtime/interface/layout.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/runtime/interface/seen.h"
#include "tests/support/sample_museum.h"
#include "tests/support/shipped_languages.h"

namespace docent::interface {
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
  for (const char16_t letter :
       *rc::gen::element(std::u16string(), std::u16string(u"b"),
                         std::u16string(u"bronze tripod of the king"), std::u16string(u"xqzj")))
    state = after(state, {Action::Kind::Type, letter});
  static Finder finder(museum());
  finder.look_up(state);
  state.page = *rc::gen::inRange(0U, 2U);
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
}  // namespace docent::interface
