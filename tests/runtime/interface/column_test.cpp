#include "runtime/interface/column.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/interface/layout.h"
#include "runtime/interface/on_glass.h"
#include "runtime/interface/seats.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/runtime/interface/seen.h"
#include "tests/support/sample_museum.h"

namespace docent::interface::column_test {
namespace {

constexpr std::array further_languages{"de", "es", "fr", "he", "hi", "ja", "ko", "ru", "th"};

/// The sample museum in all languages that words are shipped for.
Museum in_all_languages() {
  Museum museum = test::sample_museum_without_walls();
  for (const std::string tag : further_languages) {
    const auto file =
        config::load_words(test::source_dir() / "config/words" / (tag + ".toml"), tag);
    Language language;
    language.tag = tag;
    language.name = file.value->name.value;
    language.right_to_left = file.value->direction.value == "right-to-left";
    for (const auto& [key, value] : file.value->words.value) language.words[key] = value.value;
    museum.languages.push_back(std::move(language));
  }
  return museum;
}

/// Words of some length, or many short lines.
std::string any_text(std::size_t letters) {
  const auto word = *rc::gen::inRange<std::size_t>(1, 16);
  const char between = *rc::gen::inRange(0, 5) == 0 ? '\n' : ' ';
  std::string text;
  while (text.size() < letters) text += std::string(word, 'm') + between;
  text.resize(letters);
  return text;
}

Museum any_museum() {
  static const Museum plain = in_all_languages();
  Museum museum = plain;
  const auto title = *rc::gen::inRange<std::size_t>(1, 301);
  const auto text = *rc::gen::inRange<std::size_t>(1, 3001);
  for (Exhibit& exhibit : museum.exhibits) {
    exhibit.title = {{"en", any_text(title)}};
    exhibit.text = {{"en", any_text(text)}};
  }
  for (Tour& tour : museum.tours) tour.title = {{"en", any_text(title)}};
  museum.welcome = {{"en", any_text(title)}};
  return museum;
}

ViewRequest any_request(const Museum& museum) {
  ViewRequest request;
  const auto [width, height, inches] =
      *rc::gen::element(std::tuple{1024U, 768U, 24.0F}, std::tuple{768U, 1024U, 24.0F},
                        std::tuple{1920U, 1080U, 32.0F}, std::tuple{1080U, 1920U, 43.0F},
                        std::tuple{3840U, 2160U, 65.0F}, std::tuple{2160U, 3840U, 55.0F});
  request.shape = {.width = width, .height = height, .diagonal_inches = inches};
  request.shape.text_scale = *rc::gen::element(1.0F, 1.5F, 2.0F);
  request.state.large_letters = *rc::gen::arbitrary<bool>();
  request.state.screen =
      *rc::gen::element(Screen::Welcome, Screen::Choosing, Screen::Walking, Screen::Arrived);
  request.state.language =
      *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum.languages.size()));
  if (request.state.screen != Screen::Welcome) request.state.exhibit = 2;
  request.state.arrived = request.state.screen == Screen::Arrived;
  request.state.lists =
      *rc::gen::element(Listed::Exhibits, Listed::Places, Listed::OwnTour, Listed::Languages);
  for (std::uint32_t i = 0; i < 5; ++i) add_to(request.state.own_tour, i);
  if (*rc::gen::arbitrary<bool>())
    request.route_summary = RouteSummary{path::RouteStatus::Ok, 42.4, 55};
  const std::uint32_t seats = seats_on(request.shape, 4);
  if (seats > 1 && *rc::gen::inRange(0, 3) == 0) {
    request.state.glass = Glass::Busy;
    request.state.seats = static_cast<std::uint8_t>(seats);
    request.state.seat = 1 + *rc::gen::inRange(0U, seats);
    request.state.look = 1;
  }
  return request;
}

/// Sets type as boxes; what is cut is counted.
SetText counting(std::size_t& cut) {
  return [&cut](const TextStyle& style, std::string_view text, std::uint32_t width) {
    TextBitmap bitmap = test::boxes(style, text, width);
    cut += bitmap.cut ? 1 : 0;
    return bitmap;
  };
}

TEST(AnyText, IsReadAndTouchedInFullOnAnyGlassInAnyLanguage) {
  EXPECT_TRUE(rc::check("titles to 300 letters, texts to 3,000", [] {
    const Museum museum = any_museum();
    const ViewRequest request = any_request(museum);
    std::size_t cut = 0;
    PieceCache cache({counting(cut), {}}, 1, 1 << 20);
    const auto view = make_view(museum, request, cache);
    RC_LOG() << request.shape.width << " x " << request.shape.height << ", letters "
             << request.shape.text_scale << (request.state.large_letters ? " larger" : "")
             << ", screen " << static_cast<int>(request.state.screen) << ", language "
             << museum.languages[request.state.language].tag
             << (request.state.seat ? ", on a card" : "") << '\n';
    RC_ASSERT(cut == 0U);

    const ScrollArea& area = view->scroll;
    for (float offset = 0;; offset = std::min(offset + area.page, area.most())) {
      place_scrolled(*view, offset);
      const auto items = on_glass(museum, *view, request.shape, 1e6F, -1, offset);
      const auto covering = overlaps(items, request.shape);
      for (const auto& [a, b] : covering)
        RC_LOG() << items[a].name << " '" << items[a].label << "' and " << items[b].name << " '"
                 << items[b].label << "'\n";
      RC_ASSERT(covering.empty());
      RC_ASSERT(outside(items, request.shape).empty());
      if (!area.exists() || offset >= area.most()) break;
    }
    for (std::size_t i = 0; i < view->controls.size(); ++i) {
      if (view->controls[i].role == Role::Spot) continue;
      RC_LOG() << view->controls[i].name << '\n';
      RC_ASSERT(test::reached(*view, i).height > 0);
    }
  }));
}

TEST(AnyText, IsAsLargeAsOthersOfItsKind) {
  EXPECT_TRUE(rc::check("body 5 mm, controls 7", [] {
    const Museum museum = any_museum();
    const ViewRequest request = any_request(museum);
    PieceCache cache({test::boxes, {}}, 1, 1 << 20);
    const auto view = make_view(museum, request, cache);
    const float mm = measures_of(shape_for(request.shape, request.state)).mm;
    for (const Element& element : view->elements) {
      if (element.words < 0) continue;
      const Words& words = view->words[static_cast<std::size_t>(element.words)];
      RC_LOG() << words.text << '\n';
      RC_ASSERT(words.capitals_px >= 4.8F * mm || words.text == "N");  // whole pixels; a compass
      const bool is_button =
          element.control >= 0 &&
          view->controls[static_cast<std::size_t>(element.control)].role == Role::Button;
      if (is_button && !request.state.seat) RC_ASSERT(words.capitals_px >= 6.8F * mm);
    }
  }));
}

ViewRequest arrived() {
  ViewRequest request;
  request.shape.diagonal_inches = 32;
  request.state.screen = Screen::Arrived;
  request.state.arrived = true;
  request.state.exhibit = 2;
  return request;
}

TEST(ALongText, HasTwoControlsThatTurnItBeforeAllOthersAndIsSaidInFull) {
  Museum museum = test::sample_museum_without_walls();
  museum.exhibits[2].text = {{"en", std::string(2999, 'm') + "!"}};
  PieceCache cache({test::boxes, {}}, 1, 1 << 20);

  const auto view = make_view(museum, arrived(), cache);

  ASSERT_TRUE(view->scroll.exists());
  EXPECT_GT(view->scroll.length, 2 * view->scroll.rect.height);
  ASSERT_EQ(view->controls[0].name, "text-up");
  ASSERT_EQ(view->controls[1].name, "text-down");
  EXPECT_FALSE(view->controls[0].enabled) << "it is at its beginning";
  EXPECT_TRUE(view->controls[1].enabled);
  EXPECT_EQ(text_of(view->speech.controls[1]).substr(0, 12), "Further down");
  EXPECT_NE(text_of(view->speech.opening).find(museum.exhibits[2].text["en"]), std::string::npos);
}

TEST(AShortText, DoesNotScroll) {
  const Museum museum = test::sample_museum_without_walls();
  PieceCache cache({test::boxes, {}}, 1, 1 << 20);

  const auto view = make_view(museum, arrived(), cache);

  EXPECT_FALSE(view->scroll.exists());
  EXPECT_NE(view->controls[0].name, "text-up");
}

/// Everybody sees at once that there is something to listen to, and how much of it they have heard:
/// on a line below the words (Overlay::draw_listened).
TEST(AnExhibitsSound, HasItsButtonSeenWholeBeforeAnythingScrolls) {
  Museum museum = in_all_languages();
  museum.sounds = {{.exhibit = 0,
                    .title = {{"en", "One bell, two notes"}},
                    .description = {{"en", "A bell is struck twice, and dies away slowly."}}}};
  PieceCache cache({test::boxes, {}}, 1, 1 << 20);
  for (const auto& [width, height] : {std::pair{1920U, 1080U}, {1080U, 1920U}, {1280U, 1024U}})
    for (std::uint32_t language = 0; language < museum.languages.size(); ++language)
      for (const bool is_large : {false, true})
        for (const bool plays : {false, true}) {
          ViewRequest request;
          request.shape = {.width = width, .height = height, .diagonal_inches = 32};
          request.state = {.screen = Screen::Arrived,
                           .language = language,
                           .exhibit = 0,
                           .sound = plays ? std::optional<std::uint8_t>(0) : std::nullopt,
                           .can_sound = true,
                           .arrived = true,
                           .large_letters = is_large};
          const auto view = make_view(museum, request, cache);
          SCOPED_TRACE(fmt::format("{} x {} in {}, {} letters", width, height,
                                   museum.languages[language].tag, is_large ? "large" : "usual"));

          const auto button =
              std::ranges::find(view->controls, std::string("sound:1"), &Control::name);
          ASSERT_NE(button, view->controls.end());
          const float bottom = button->rect.y + button->rect.height;
          const auto index = static_cast<std::int32_t>(button - view->controls.begin());
          const bool scrolls =
              std::ranges::find(view->scroll.controls, index, &ScrollArea::Scrolled::control) !=
              view->scroll.controls.end();
          EXPECT_GT(button->rect.width, 0);
          if (scrolls) {
            EXPECT_LE(bottom, view->scroll.rect.y + view->scroll.rect.height + 1e-4F);
          }
          for (const Element& element : view->elements)
            if (element.control == index && element.words >= 0) {
              EXPECT_LE(element.quad.rect.y + element.quad.rect.height,
                        bottom - view->unit_px / view->pixel_height);
            }
        }
}

}  // namespace
}  // namespace docent::interface::column_test
