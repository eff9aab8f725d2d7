#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/guide/guide.h"
#include "tests/runtime/guide/simulated.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::lit_doorways_test {
namespace {

GuideSettings settings() {
  return {.shape = {.width = 1280, .height = 720}};
}

struct Visitor {
  Visitor()
      : planner(test::sample_museum(), {test::boxes, {}},
                planner_size(test::sample_museum(), settings()).avatars,
                planner_size(test::sample_museum(), settings()).parts),
        guide(test::sample_museum(), planner, settings()) {
    run(0.2);
  }
  void run(double seconds) { test::run(planner, guide, seconds); }
  std::ptrdiff_t lit_doorways() {
    return std::ranges::count(guide.draw_list().markers, scene::MarkerDraw::Kind::Doorway,
                              &scene::MarkerDraw::kind);
  }
  plan::Planner planner;
  Guide guide;
};

/// The exhibit is in another gallery than the kiosk.
TEST(Doorways, OfTheWayGlowUntilTheGuideHasGoneThrough) {
  Visitor visitor;
  test::tap(visitor.planner, visitor.guide, "begin");
  visitor.run(1.5);
  EXPECT_EQ(visitor.lit_doorways(), 0);
  test::tap(visitor.planner, visitor.guide, "exhibit:painted-jar");
  visitor.run(1);

  std::ptrdiff_t lit = visitor.lit_doorways();
  EXPECT_GT(lit, 0);
  for (int second = 0; second < 120 && !visitor.guide.state().arrived; ++second) {
    visitor.run(1);
    EXPECT_LE(visitor.lit_doorways(), lit);
    lit = visitor.lit_doorways();
  }
  ASSERT_TRUE(visitor.guide.state().arrived);
  EXPECT_EQ(lit, 0);
}

}  // namespace
}  // namespace docent::guide::lit_doorways_test
