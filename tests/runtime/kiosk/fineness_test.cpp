#include "runtime/kiosk/fineness.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace docent::kiosk::fineness_test {
namespace {

constexpr PixelSize full_hd{1920, 1080}, four_k{3840, 2160};

/// A machine that needs as long for a frame as it has pixels; in so many milliseconds all of them.
void draw(Fineness& fineness, int frames, double milliseconds, PixelSize screen = full_hd) {
  for (int frame = 0; frame < frames; ++frame) {
    const double share = fineness.share();
    fineness.took(std::max(milliseconds * share * share, 16.7) / 1000, screen);
  }
}

TEST(Fineness, IsTheScreensWhereFramesAreQuick) {
  Fineness fineness;
  draw(fineness, 1000, 16.7);
  EXPECT_EQ(fineness.share(), 1);
}

TEST(Fineness, IsSoMuchLessThatTwentyFramesASecondAreDrawn) {
  Fineness fineness;
  draw(fineness, 100, 80);
  EXPECT_EQ(fineness.share(), 0.75F);
  draw(fineness, 100, 190);
  EXPECT_EQ(fineness.share(), 0.5F);
}

TEST(Fineness, IsFoundWithinASecondAndAHalf) {
  Fineness fineness;
  double seconds = 0;
  while (fineness.share() > 0.5F) {
    const double took = 0.19 * fineness.share() * fineness.share();
    fineness.took(took, full_hd);
    seconds += took;
  }
  EXPECT_LT(seconds, 1.5);
}

TEST(Fineness, KeepsFourHundredLines) {
  Fineness fineness, larger, smaller, turned;
  draw(fineness, 1000, 9000);
  EXPECT_EQ(fineness.share(), 0.375F);
  draw(smaller, 1000, 9000, {1024, 768});
  EXPECT_EQ(smaller.share(), 0.75F);
  draw(larger, 1000, 9000, four_k);
  EXPECT_EQ(larger.share(), 0.1875F);
  draw(turned, 1000, 9000, {1080, 1920});
  EXPECT_EQ(turned.share(), 0.375F);
}

TEST(Fineness, StaysThroughAFrameThatIsHeldUp) {
  Fineness fineness;
  for (int i = 0; i < 100; ++i) {
    draw(fineness, 3, 16.7);
    fineness.took(2, full_hd);
  }
  EXPECT_EQ(fineness.share(), 1);
}

TEST(Fineness, ComesBackOnceTheMachineHasTime) {
  Fineness fineness;
  draw(fineness, 100, 190);
  draw(fineness, 1000, 30);
  EXPECT_EQ(fineness.share(), 1);
}

/// A picture that gets finer and coarser by turns is worse than a coarse one.
TEST(Fineness, DoesNotWaver) {
  Fineness fineness;
  int changes = 0;
  for (int frame = 0; frame < 36'000; ++frame) {  // half an hour at 20 a second
    const float before = fineness.share();
    // The finer picture looks affordable, and is not.
    fineness.took(before == 1 ? 0.051 : 0.02, full_hd);
    changes += fineness.share() != before ? 1 : 0;
  }
  EXPECT_LE(changes, 24);
}

}  // namespace
}  // namespace docent::kiosk::fineness_test
