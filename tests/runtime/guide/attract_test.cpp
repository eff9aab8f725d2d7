// What the museum does while nobody is there.
#include "runtime/guide/attract.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/guide/guide.h"
#include "runtime/scene/shown_list.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::attract_test {
namespace {

struct Kiosk {
  explicit Kiosk(GuideSettings settings = {.shape = {.width = 1920, .height = 1080}})
      : planner(test::sample_museum(), {test::boxes, {}},
                planner_size(test::sample_museum(), settings).avatars,
                planner_size(test::sample_museum(), settings).parts),
        guide(test::sample_museum(), planner, settings) {
    run(1);
  }
  void run(double seconds) { test::run(planner, guide, seconds); }
  void touch(input::InputEvent::Kind kind) {
    guide.touch({.kind = kind, .contact = {1, 0.95F, 0.1F}});
  }
  /// The first frame in which that is true, in seconds from now; below 0 where none is.
  double seconds_until(double most, const auto& is_true) {
    for (int frame = 0; frame < most * 60; ++frame) {
      if (is_true(guide.draw_list())) return frame / 60.0;
      run(1.0 / 60);
    }
    return -1;
  }

  plan::Planner planner;
  Guide guide;
};

bool has_way(const scene::DrawList& list) {
  return !list.ribbons.empty() && list.ribbons.front().opacity > 0;
}

/// All that is on the glass but the rings that answer touches.
std::vector<scene::Quad> glass(const scene::DrawList& list) {
  std::vector<scene::Quad> quads = list.quads;
  std::erase_if(quads, [](const scene::Quad& it) { return it.fill == scene::QuadFill::Ring; });
  return quads;
}

TEST(TheMuseum, LivesAfterAMinuteAloneAndNotBefore) {
  Kiosk kiosk;

  kiosk.run(58);
  EXPECT_FALSE(kiosk.guide.is_attracting());
  EXPECT_EQ(kiosk.guide.draw_list().avatars.size(), 1U);
  kiosk.run(4);
  EXPECT_TRUE(kiosk.guide.is_attracting());
  EXPECT_GT(kiosk.guide.draw_list().avatars.size(), 3U) << "strollers";
  EXPECT_EQ(kiosk.guide.state().screen, interface::Screen::Welcome);
}

TEST(TheMuseum, ShowsAWayToAnExhibitThatTheGuideWalksAndComesHome) {
  Kiosk kiosk;
  kiosk.run(61);

  ASSERT_GT(kiosk.seconds_until(30, has_way), 0);
  const scene::DrawList& list = kiosk.guide.draw_list();
  const scene::RibbonDraw& way = list.ribbons.front();
  const Vec2 begins = list.ribbon_point[way.first];
  const Vec2 ends = list.ribbon_point[way.first + way.count - 1];
  EXPECT_LT(glm::distance(begins, test::sample_museum().kiosk.position), 0.5);
  const auto shown =
      std::ranges::find_if(test::sample_museum().exhibits, [&](const Exhibit& exhibit) {
        return glm::distance(exhibit.viewing_point.position, ends) < 0.1;
      });
  ASSERT_NE(shown, test::sample_museum().exhibits.end());
  const auto is_at = [&](Vec2 place) {
    return [&kiosk, place](const scene::DrawList&) {
      return glm::distance(kiosk.guide.crowd()[0].avatar.body.position, place) < 0.3;
    };
  };
  EXPECT_GT(kiosk.seconds_until(90, is_at(ends)), 0);
  EXPECT_GT(kiosk.seconds_until(90, is_at(test::sample_museum().kiosk.position)), 0);
  EXPECT_GT(kiosk.seconds_until(120, has_way), 0) << "and another one";
  EXPECT_EQ(kiosk.guide.counters().collisions, 0U);
}

/// Who passes by sees whose museum it is.
TEST(TheMuseum, HasItsSignOnTheBoardOfItsWelcome) {
  Museum museum = test::sample_museum();
  museum.livery.logo = static_cast<std::uint32_t>(museum.images.size());
  museum.images.push_back({.name = "logo.png", .width = 120, .height = 108, .bytes = {}});
  plan::Planner planner(museum,
                        {test::boxes,
                         [](std::uint32_t, std::uint32_t width, std::uint32_t height) {
                           return Pixels{width, height,
                                         std::vector<std::byte>(std::size_t{4} * width * height)};
                         }},
                        planner_size(museum, {}).avatars, planner_size(museum, {}).parts);
  Guide guide(museum, planner, {.shape = {.width = 1920, .height = 1080}});
  test::run(planner, guide, 1);
  const auto logo = std::ranges::find_if(guide.view()->elements, [](const auto& element) {
    return element.greets && element.quad.fill == scene::QuadFill::Image;
  });
  ASSERT_NE(logo, guide.view()->elements.end());
  test::run(planner, guide, 66);
  ASSERT_TRUE(guide.is_attracting());

  const std::vector<scene::Quad>& quads = guide.draw_list().quads;
  const auto board = std::ranges::find_if(quads, [&](const scene::Quad& quad) {
    return quad.colour == guide.view()->theme.paper && quad.colour.a == 1;
  });
  ASSERT_NE(board, quads.end());
  const auto sign = std::find_if(board, quads.end(), [&](const scene::Quad& quad) {
    return quad.texture == logo->quad.texture;
  });
  ASSERT_NE(sign, quads.end());
  EXPECT_TRUE(scene::contains(board->rect, sign->rect.x, sign->rect.y));
  EXPECT_TRUE(scene::contains(board->rect, sign->rect.x + sign->rect.width,
                              sign->rect.y + sign->rect.height));
  EXPECT_EQ(sign->colour.a, 1);
  for (auto words = sign + 1; words != quads.end(); ++words)
    EXPECT_TRUE(words->rect.x > sign->rect.x + sign->rect.width ||
                words->rect.y > sign->rect.y + sign->rect.height)
        << "words are beside it or below it";
  EXPECT_EQ(quads.end() - sign, 4) << "its name and its welcome, and nothing that is to be touched";
}

TEST(TheMuseum, IsNotTouchedByAFingerThatHasRestedOnTheGlassAllTheWhile) {
  Kiosk kiosk;
  const scene::Rect begin = kiosk.guide.view()->controls.front().rect;
  const input::Contact finger{1, begin.x + begin.width / 2, begin.y + begin.height / 2};
  kiosk.guide.touch({.kind = input::InputEvent::Kind::Down, .contact = finger});
  kiosk.run(61);
  ASSERT_TRUE(kiosk.guide.is_attracting());

  kiosk.guide.touch({.kind = input::InputEvent::Kind::Up, .contact = finger});
  kiosk.run(1);

  EXPECT_TRUE(kiosk.guide.is_attracting());
  EXPECT_EQ(kiosk.guide.state().screen, interface::Screen::Welcome);
}

TEST(TheMuseum, IsNeverWithoutItsGuide) {
  Kiosk kiosk;
  kiosk.run(58);
  for (int frame = 0; frame < 4 * 60; ++frame) {
    ASSERT_GE(kiosk.guide.draw_list().avatars.size(), 1U) << frame;
    EXPECT_EQ(kiosk.guide.draw_list().avatars[0].look, 0U) << frame;
    kiosk.run(1.0 / 60);
  }
  ASSERT_TRUE(kiosk.guide.is_attracting());

  kiosk.touch(input::InputEvent::Kind::Down);
  for (int frame = 0; frame < 30; ++frame) {
    kiosk.run(1.0 / 60);
    ASSERT_EQ(kiosk.guide.draw_list().avatars.size(), 1U) << frame;
  }
}

TEST(TheMuseum, IsThereForWhoPlugsHeadphonesIn) {
  Kiosk kiosk;
  kiosk.run(61);
  ASSERT_TRUE(kiosk.guide.is_attracting());

  kiosk.guide.headphones(true);

  EXPECT_FALSE(kiosk.guide.is_attracting());
}

TEST(TheMuseum, GivesTheFirstScreenBackInTheFrameOfATouch) {
  for (const double alone : {60.5, 66.0, 80.0, 130.0}) {
    Kiosk kiosk;
    const std::vector<scene::Quad> before = glass(kiosk.guide.draw_list());
    const scene::DrawList first = kiosk.guide.draw_list();
    kiosk.run(alone);
    ASSERT_TRUE(kiosk.guide.is_attracting());

    kiosk.touch(input::InputEvent::Kind::Down);
    kiosk.run(1.0 / 60);

    const scene::DrawList& list = kiosk.guide.draw_list();
    EXPECT_FALSE(kiosk.guide.is_attracting());
    EXPECT_TRUE(glass(list) == before) << alone;
    EXPECT_TRUE(list.camera == first.camera) << alone;
    EXPECT_TRUE(list.light == first.light);
    EXPECT_TRUE(list.markers == first.markers);
    EXPECT_TRUE(list.ribbons.empty());
    ASSERT_EQ(list.avatars.size(), 1U);
    EXPECT_LT(glm::distance(kiosk.guide.crowd()[0].avatar.body.position,
                            test::sample_museum().kiosk.position),
              0.01);
    // What the finger lies on was not there when it came down.
    kiosk.touch(input::InputEvent::Kind::Up);
    kiosk.run(0.5);
    EXPECT_EQ(kiosk.guide.state().screen, interface::Screen::Welcome);
    kiosk.touch(input::InputEvent::Kind::Down);
    kiosk.touch(input::InputEvent::Kind::Up);
    kiosk.run(0.1);
    EXPECT_EQ(kiosk.guide.state().screen, interface::Screen::Choosing);
  }
}

TEST(TheMuseum, IsWokenByAKeyThatDoesWhatItAlwaysDoes) {
  Kiosk kiosk;
  kiosk.run(70);
  ASSERT_TRUE(kiosk.guide.is_attracting());

  kiosk.guide.touch(
      {.kind = input::InputEvent::Kind::KeyDown, .contact = {}, .key = input::Key::Enter});
  kiosk.run(0.1);

  EXPECT_FALSE(kiosk.guide.is_attracting());
  EXPECT_EQ(kiosk.guide.state().screen, interface::Screen::Choosing);
}

TEST(TheMuseum, LeavesNoLightAsItIsForAMinute) {
  Kiosk kiosk;
  kiosk.run(62);
  scene::ShownList shown;
  float darkest = 1, brightest = 0;
  int still = 0;
  for (int frame = 0; frame < 60 * 60; ++frame) {
    const scene::DrawList& list = kiosk.guide.draw_list();
    darkest = std::min(darkest, scene::luminance(list.light.paper));
    brightest = std::max(brightest, scene::luminance(list.light.paper));
    still += shown.differs(list, 1080) ? 0 : 1;
    shown.keep(list);
    kiosk.run(1.0 / 60);
  }

  EXPECT_LT(darkest, 0.5F * brightest);
  EXPECT_EQ(still, 0) << "it is always another picture";
}

TEST(TheMuseum, DoesNothingByItselfWhereMotionIsReduced) {
  Kiosk kiosk({.shape = {.width = 1920, .height = 1080}, .reduced_motion = true});
  scene::ShownList shown;
  shown.keep(kiosk.guide.draw_list());
  int drawn = 0;
  for (int second = 0; second < 200; ++second) {
    kiosk.run(1);
    drawn += shown.differs(kiosk.guide.draw_list(), 1080) ? 1 : 0;
  }

  EXPECT_FALSE(kiosk.guide.is_attracting());
  EXPECT_EQ(drawn, 0);
}

TEST(TheMuseum, LivesOnASharedGlassToo) {
  Kiosk kiosk({.shape = {.width = 1920, .height = 1080, .diagonal_inches = 55}, .visitors = 8});
  ASSERT_GT(kiosk.guide.seats(), 1U);
  kiosk.run(61);
  ASSERT_TRUE(kiosk.guide.is_attracting());
  ASSERT_GT(kiosk.seconds_until(40, has_way), 0);

  kiosk.touch(input::InputEvent::Kind::Down);
  kiosk.run(0.1);

  EXPECT_FALSE(kiosk.guide.is_attracting());
  EXPECT_TRUE(kiosk.guide.is_vacant());
  EXPECT_TRUE(kiosk.guide.draw_list().ribbons.empty());
  EXPECT_EQ(kiosk.guide.counters().collisions, 0U);
}

}  // namespace
}  // namespace docent::guide::attract_test
