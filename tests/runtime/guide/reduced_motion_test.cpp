#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/guide/guide.h"
#include "runtime/scene/shown_list.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::reduced_motion_test {
namespace {

enum class Motion : std::uint8_t { Full, Reduced };

/// A kiosk of one visitor, in simulated time.
struct Kiosk {
  explicit Kiosk(Motion motion)
      : planner(test::sample_museum(), {test::boxes, {}}),
        guide(test::sample_museum(), planner,
              {.shape = {.width = 1920, .height = 1080},
               .idle_reset = Seconds{600},
               .reduced_motion = motion == Motion::Reduced}) {
    run(0.1);
  }

  void run(double seconds) { test::run(planner, guide, seconds); }

  void tap(std::string_view name) { test::tap(planner, guide, name); }

  /// Of so many seconds' frames, how many would have to be drawn.
  int drawn_in(double seconds, float pixels_high) {
    scene::ShownList shown;
    shown.keep(guide.draw_list());
    int drawn = 0;
    for (int frame = 0; frame < static_cast<int>(seconds * 60); ++frame) {
      run(1.0 / 60);
      if (!shown.differs(guide.draw_list(), pixels_high)) continue;
      shown.keep(guide.draw_list());
      ++drawn;
    }
    return drawn;
  }

  plan::Planner planner;
  Guide guide;
};

TEST(ReducedMotion, LeavesTheWelcomeScreenAsItIs) {
  Kiosk kiosk(Motion::Reduced);
  kiosk.run(1);

  EXPECT_EQ(kiosk.drawn_in(20, 1e6F), 0);
}

TEST(ReducedMotion, IsNotNeededForMostFramesOfTheWelcomeScreenToBeTheSame) {
  Kiosk kiosk(Motion::Full);
  kiosk.run(2);
  const int drawn = kiosk.drawn_in(20, 1080);

  EXPECT_GT(drawn, 0) << "the guide breathes, shifts its weight and looks about";
  EXPECT_LT(drawn, 20 * 60 / 2);
}

TEST(ReducedMotion, ShowsTheNextScreenAtOnce) {
  Kiosk kiosk(Motion::Reduced);
  kiosk.tap("begin");

  kiosk.run(2.0 / 60);
  EXPECT_EQ(kiosk.guide.state().screen, interface::Screen::Choosing);
  EXPECT_TRUE(kiosk.guide.is_settled());
  kiosk.run(1);  // the ring that answered the touch
  EXPECT_EQ(kiosk.drawn_in(5, 1e6F), 0);
}

TEST(ReducedMotion, FollowsAWalkInStepsAndNeverLosesIt) {
  Kiosk kiosk(Motion::Reduced);
  kiosk.tap("begin");
  kiosk.run(0.1);
  scene::CameraView before = kiosk.guide.draw_list().camera;
  const Exhibit& farthest =
      *std::ranges::max_element(test::sample_museum().exhibits, {}, [](const Exhibit& e) {
        return glm::distance(e.viewing_point.position, test::sample_museum().kiosk.position);
      });
  kiosk.tap("exhibit:" + farthest.id);
  int frames = 0, cuts = 0;
  for (; frames < 60 * 60 && !kiosk.guide.state().arrived; ++frames) {
    kiosk.run(1.0 / 60);
    const scene::DrawList& list = kiosk.guide.draw_list();
    cuts += list.camera == before ? 0 : 1;
    before = list.camera;
    if (kiosk.guide.state().screen != interface::Screen::Walking) continue;
    const auto guide = scene::project(list.camera, list.avatars[0].centre);
    ASSERT_TRUE(guide.has_value());
    EXPECT_TRUE(scene::contains(kiosk.guide.view()->free, guide->x, guide->y)) << frames;
  }

  EXPECT_TRUE(kiosk.guide.state().arrived);
  EXPECT_GT(cuts, 3);
  EXPECT_LT(cuts, frames / 30) << frames << " frames";
}

}  // namespace
}  // namespace docent::guide::reduced_motion_test
