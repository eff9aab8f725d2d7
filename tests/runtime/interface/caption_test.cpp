#include "runtime/interface/caption.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/runtime/interface/boxes.h"
#include "tests/support/sample_museum.h"

namespace docent::interface::caption_test {
namespace {

using test::boxes;

const Museum& museum() {
  static const Museum it = test::sample_museum_without_walls();
  return it;
}

ViewRequest said(SpeechPart::Kind kind, Screen screen) {
  ViewRequest request;
  request.state.screen = screen;
  request.state.exhibit = 0;
  request.state.arrived = screen == Screen::Arrived;
  request.state.speaks = true;
  request.said = SpeechPart{kind, 0};
  return request;
}

std::unique_ptr<View> caption_of(const ViewRequest& request) {
  PieceCache cache({boxes, {}}, 1, 1 << 20);
  return make_caption(museum(), request, cache);
}

TEST(Caption, ShowsAllThatIsSaidPageByPage) {
  for (const std::uint32_t language : {0U, 1U, 2U}) {
    ViewRequest request = said(SpeechPart::Kind::Opening, Screen::Arrived);
    request.state.language = language;
    const auto view = caption_of(request);

    ASSERT_FALSE(view->remaining.empty());
    std::string shown;
    for (auto page = view->remaining.rbegin(); page != view->remaining.rend(); ++page)
      shown += view->words[static_cast<std::size_t>(page->words)].text;
    PieceCache cache({boxes, {}}, 1, 1 << 20);
    request.said.reset();
    EXPECT_EQ(shown, text_of(make_view(museum(), request, cache)->speech.opening));
    EXPECT_TRUE(std::ranges::is_sorted(view->remaining, {}, &CountedText::metres));
    EXPECT_GE(view->remaining.back().metres, 1) << "the first page, from the beginning";
  }
}

TEST(Caption, TurnsItsPagesAsLongAsTheSpeechThatWasPreparedTakes) {
  Museum spoken = museum();
  const Exhibit& exhibit = spoken.exhibits[0];
  for (std::string& piece : spoken_pieces(spoken, 0)) {
    const bool is_title = exhibit.title.at("en").starts_with(piece);
    spoken.speech.push_back({.language = 0,
                             .text = std::move(piece),
                             .made_of = {},
                             .samples = (is_title ? 30 : 2) * SpeechSound::rate,
                             .packets = {}});
  }
  PieceCache cache({boxes, {}}, 1, 1 << 20);
  const ViewRequest request = said(SpeechPart::Kind::Opening, Screen::Arrived);
  const auto view = make_caption(spoken, request, cache);

  ASSERT_GE(view->remaining.size(), 2U);
  const CountedText& second = view->remaining[view->remaining.size() - 2];
  EXPECT_LT(second.metres, 4.0F / 30) << "the title takes nearly all of the time";
  EXPECT_GT(second.metres, 0);
}

TEST(Caption, CoversNothingThatCanBeTouched) {
  for (const Screen screen : {Screen::Welcome, Screen::Choosing, Screen::Walking, Screen::Arrived})
    for (const bool larger : {false, true})
      for (const std::uint32_t language : {0U, 2U}) {
        ViewRequest request = said(SpeechPart::Kind::Opening, screen);
        request.state.large_letters = larger;
        request.state.language = language;
        const auto view = caption_of(request);
        ViewRequest below = request;
        below.said.reset();
        PieceCache cache({boxes, {}}, 1, 1 << 20);
        const auto under = make_view(museum(), below, cache);

        const scene::Rect box = view->panel;
        ASSERT_GT(box.width, 0);
        EXPECT_GE(box.y, 0);
        for (const Control& control : under->controls) {
          if (control.role == Role::Spot) continue;
          const scene::Rect& r = control.rect;
          EXPECT_FALSE(r.width > 0 && r.x < box.x + box.width && box.x < r.x + r.width &&
                       r.y < box.y + box.height && box.y < r.y + r.height)
              << control.name << " on screen " << static_cast<int>(screen);
        }
      }
}

TEST(Caption, IsEmptyWhereNothingIsSaid) {
  EXPECT_TRUE(caption_of(said(SpeechPart::Kind::Silence, Screen::Choosing))->elements.empty());
}

}  // namespace
}  // namespace docent::interface::caption_test
