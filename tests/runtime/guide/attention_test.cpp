#include "runtime/guide/attention.h"

#include <gtest/gtest.h>

#include "runtime/guide/guide.h"
#include "runtime/interface/seats.h"
#include "runtime/scene/camera.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::attention_test {
namespace {

struct Kiosk {
  Kiosk(const Museum& shown, const GuideSettings& settings)
      : planner(shown, {test::boxes, {}}, planner_size(shown, settings).avatars,
                planner_size(shown, settings).parts),
        guide(shown, planner, settings) {
    run(0.2);
  }
  void run(double seconds) { test::run(planner, guide, seconds); }
  void tap(float x, float y) {
    for (const auto kind : {input::InputEvent::Kind::Down, input::InputEvent::Kind::Up}) {
      guide.touch({.kind = kind, .contact = {1, x, y}});
      run(0.05);
    }
  }
  plan::Planner planner;
  Guide guide;
};

TEST(Attention, IsGivenToTheCameraWhereOneVisitorHasTheGlass) {
  Kiosk kiosk(test::sample_museum(), {.shape = {.width = 1920, .height = 1080}});
  kiosk.tap(0.9F, 0.1F);
  kiosk.run(3);  // until the camera rests

  const Company& company = kiosk.guide.crowd()[0].avatar.company;

  ASSERT_TRUE(company.visitor);
  EXPECT_TRUE(company.is_used);
  EXPECT_LT(glm::distance(*company.visitor, kiosk.guide.draw_list().camera.eye), 0.05F);
}

TEST(Attention, IsGivenByEachGuideToTheCardOfItsVisitor) {
  const GuideSettings settings{.shape = {.width = 1920, .height = 1080, .diagonal_inches = 55},
                               .idle_reset = Seconds{120},
                               .visitors = 8};
  Kiosk kiosk(test::sample_museum(), settings);
  for (const std::uint32_t seat : {1U, 8U}) {
    const scene::Rect column = interface::column_of(settings.shape, 8, seat);
    kiosk.tap(column.x + column.width / 2, 0.95F);
    const auto& controls = kiosk.guide.view(kiosk.guide.part_of(seat))->controls;
    const auto look = std::ranges::find_if(controls, [](const interface::Control& control) {
      return control.name.starts_with("look:") && control.enabled;
    });
    ASSERT_NE(look, controls.end());
    kiosk.tap(look->rect.x + look->rect.width / 2, look->rect.y + look->rect.height / 2);
  }
  kiosk.run(0.3);

  for (const std::uint32_t seat : {1U, 8U}) {
    const interface::InterfaceState& state = kiosk.guide.state(kiosk.guide.part_of(seat));
    ASSERT_TRUE(state.look) << seat;
    const Avatar& avatar = kiosk.guide.crowd()[*state.look].avatar;
    ASSERT_TRUE(avatar.company.visitor) << seat;
    const auto seen = scene::project(kiosk.guide.draw_list().camera, *avatar.company.visitor);
    const scene::Rect card = interface::card_of(settings.shape, 8, seat);
    ASSERT_TRUE(seen) << seat;
    EXPECT_NEAR(seen->x, card.x + card.width / 2, 0.005F) << seat;
    EXPECT_NEAR(seen->y, card.y + card.height / 2, 0.005F) << seat;
    EXPECT_EQ(avatar.manner.gesture, motion::Gesture::Wave) << "whom it has just met";
  }
}

TEST(Attention, IsGivenNowAndThenToStrollersWhoPassAndSomeWaveBack) {
  Museum busy = test::sample_museum();
  busy.ambient.count = 12;
  busy.ambient.entrances = {busy.kiosk.position + Vec2{1.2, 1.5}};
  Kiosk kiosk(busy, {.shape = {.width = 1920, .height = 1080}});
  int waves = 0, returned = 0;
  std::vector<double> last(kiosk.guide.crowd().size(), Manner::never);
  for (int frame = 0; frame < 60 * 240; ++frame) {
    kiosk.run(1.0 / 60);
    for (std::uint32_t who = 0; who < kiosk.guide.crowd().size(); ++who) {
      const Manner& manner = kiosk.guide.crowd()[who].avatar.manner;
      if (manner.waved == last[who]) continue;
      EXPECT_GT(manner.waved - last[who], 19) << who << ": nobody waves all the time";
      last[who] = manner.waved;
      (who == 0 ? waves : returned) += 1;
    }
  }
  EXPECT_GE(waves, 1);
  EXPECT_LE(waves, 12);
  EXPECT_GE(returned, 1);
  EXPECT_LE(returned, waves * 2);
}

}  // namespace
}  // namespace docent::guide::attention_test
