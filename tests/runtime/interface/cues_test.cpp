#include "runtime/interface/cues.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/scene/theme.h"
#include "tests/runtime/interface/boxes.h"
#include "tests/support/sample_museum.h"

namespace docent::interface::cues_test {
namespace {

/// The sample museum; the first exhibit's second picture is a video with captions in English and
/// Arabic, but not in Chinese.
Museum museum_with_captions() {
  Museum museum = test::sample_museum_without_walls();
  museum.images.push_back(
      {.name = "images/turning.webm", .width = 1280, .height = 720, .bytes = {}});
  museum.pictures = {{.exhibit = 0, .image = static_cast<std::uint32_t>(museum.images.size() - 1)}};
  std::string longest;
  while (longest.size() < 200) longest += longest.empty() ? "water" : " water";
  museum.cues = {{.picture = 0, .language = 0, .begin = 500, .end = 2000, .text = "It turns."},
                 {.picture = 0, .language = 0, .begin = 3000, .end = 9000, .text = longest},
                 {.picture = 0, .language = 2, .begin = 500, .end = 2000, .text = "يدور."}};
  return museum;
}

Pixels grey(std::uint32_t, std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<std::byte>(std::size_t{4} * width * height, std::byte{128})};
}

ViewRequest watching(std::uint32_t language) {
  ViewRequest request;
  request.state.screen = Screen::Arrived;
  request.state.arrived = true;
  request.state.exhibit = 0;
  request.state.picture = std::uint8_t{1};
  request.state.plays = true;
  request.state.language = language;
  return request;
}

std::unique_ptr<View> view_of(const Museum& museum, const ViewRequest& request,
                              SetPicture set_picture = grey) {
  PieceCache cache({test::boxes, std::move(set_picture)}, 1, 1 << 24);
  return make_view(museum, request, cache);
}

const scene::Rect& video_of(const View& view) {
  return std::ranges::find(view.elements, view.video,
                           [](const Element& one) { return one.quad.texture; })
      ->quad.rect;
}

bool is_within(const scene::Rect& inner, const scene::Rect& outer) {
  constexpr float least = 1e-5F;
  return inner.x >= outer.x - least && inner.y >= outer.y - least &&
         inner.x + inner.width <= outer.x + outer.width + least &&
         inner.y + inner.height <= outer.y + outer.height + least;
}

std::string words_of(const View& view, const TimedText& cue) {
  return view.words[static_cast<std::size_t>(cue.words)].text;
}

TEST(Cues, AreReadAtTheirTimes) {
  const Museum museum = museum_with_captions();
  const auto view = view_of(museum, watching(0));

  ASSERT_GE(view->cues.size(), 2U);
  EXPECT_EQ(words_of(*view, view->cues[0]), "It turns.");
  EXPECT_FLOAT_EQ(view->cues[0].begin, 0.5F);
  EXPECT_FLOAT_EQ(view->cues[0].end, 2);
  EXPECT_FLOAT_EQ(view->cues[1].begin, 3);
  EXPECT_NEAR(view->cues.back().end, 9, 1e-4);
}

TEST(Cues, HaveAllOfALongTextPageByPage) {
  const Museum museum = museum_with_captions();
  const auto view = view_of(museum, watching(0));

  ASSERT_GT(view->cues.size(), 2U) << "more than a page";
  std::string all;
  for (std::size_t i = 1; i < view->cues.size(); ++i) {
    if (i > 1) {
      EXPECT_FLOAT_EQ(view->cues[i].begin, view->cues[i - 1].end);
    }
    all += (all.empty() ? "" : " ") + words_of(*view, view->cues[i]);
  }
  EXPECT_EQ(all, museum.cues[1].text);
}

TEST(Cues, LieInTheLowerHalfOfTheVideoInAnyLanguageAndSizeOfLetters) {
  const Museum museum = museum_with_captions();
  for (const auto& [width, height] : {std::pair{1920U, 1080U}, std::pair{1080U, 1920U}})
    for (const bool large : {false, true})
      for (const std::uint32_t language : {0U, 2U}) {
        ViewRequest request = watching(language);
        request.shape.width = width;
        request.shape.height = height;
        request.state.large_letters = large;
        const auto view = view_of(museum, request);
        ASSERT_NE(view->video, scene::TextureId::None);
        ASSERT_FALSE(view->cues.empty());
        const scene::Rect& video = video_of(*view);

        for (const TimedText& cue : view->cues) {
          EXPECT_TRUE(is_within(cue.ground.rect, video))
              << width << ' ' << large << ' ' << language;
          EXPECT_TRUE(is_within(cue.quad.rect, cue.ground.rect));
          // A line of usual Arabic letters takes that of the small picture on an upright glass.
          EXPECT_GE(cue.ground.rect.y, video.y + 0.45F * video.height) << "most of it is seen";
          for (const Control& control : view->controls) {
            const scene::Rect &r = control.rect, &box = cue.ground.rect;
            EXPECT_FALSE(r.width > 0 && r.x < box.x + box.width && box.x < r.x + r.width &&
                         r.y < box.y + box.height && box.y < r.y + r.height)
                << control.name;
          }
        }
      }
}

float size_of_capitals(const View& view) {
  return view.words[static_cast<std::size_t>(view.cues.front().words)].capitals_px;
}

TEST(Cues, AreLargerForWhoAsksForThatAsFarAsThePictureIsStillSeen) {
  const Museum museum = museum_with_captions();
  for (const float inches : {15.0F, 24.0F, 55.0F}) {
    ViewRequest request = watching(0);
    request.shape.diagonal_inches = inches;
    const auto usual = view_of(museum, request);
    request.state.large_letters = true;
    const auto large = view_of(museum, request);

    const float times = size_of_capitals(*large) / size_of_capitals(*usual);
    EXPECT_GE(times, 1) << inches;
    EXPECT_LE(times, 1.52F) << inches;
    const scene::Rect& video = video_of(*large);
    for (const TimedText& cue : large->cues)
      EXPECT_LE(cue.ground.rect.height, 0.42F * video.height) << inches;
    if (inches > 24) {
      EXPECT_GT(times, 1.4F) << "there is room";
    }
  }
}

TEST(Cues, HaveLettersOfFiveMillimetresAndTheContrastOfText) {
  const Museum museum = museum_with_captions();
  for (const bool is_high : {false, true})
    for (const bool is_night : {false, true}) {
      ViewRequest request = watching(0);
      request.state.high_contrast = is_high;
      request.shape.is_night = is_night;
      const auto view = view_of(museum, request);
      const scene::Theme theme = scene::theme_of(museum.livery, is_high, is_night);

      ASSERT_FALSE(view->cues.empty());
      EXPECT_EQ(view->cues[0].ground.colour, theme.ink) << "theme_test.cpp: 7:1 on paper";
      EXPECT_EQ(view->cues[0].quad.colour, theme.paper);
      const float capitals = view->words[static_cast<std::size_t>(view->cues[0].words)].capitals_px;
      EXPECT_GE(capitals + 0.5F, 5 * measures_of(request.shape).mm);
    }
}

TEST(Cues, AreThoseOfAnotherLanguageWhereTheVisitorsHasNone) {
  const Museum museum = museum_with_captions();
  const auto view = view_of(museum, watching(1));

  ASSERT_FALSE(view->cues.empty());
  EXPECT_EQ(words_of(*view, view->cues[0]), "It turns.");
}

TEST(Cues, AreNotThereWithoutTheVideo) {
  const Museum museum = museum_with_captions();
  ViewRequest request = watching(0);
  EXPECT_TRUE(view_of(museum, request, {})->cues.empty()) << "it is not drawn yet";
  request.state.picture.reset();
  EXPECT_TRUE(view_of(museum, request)->cues.empty()) << "the exhibit's own picture";
}

}  // namespace
}  // namespace docent::interface::cues_test
