#include "runtime/kiosk/pixel_shift.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <utility>

namespace docent::kiosk::pixel_shift_test {
namespace {

TEST(PixelShift, StaysForAMinuteAndThenWaitsForAChange) {
  PixelShift shift;

  shift.advance(59, true);
  EXPECT_EQ(shift.at(), PixelOffset{});
  shift.advance(2, false);
  EXPECT_EQ(shift.at(), PixelOffset{}) << "somebody might see it";
  shift.advance(0.1, true);
  EXPECT_EQ(shift.at(), (PixelOffset{1, 0}));
}

TEST(PixelShift, MovesWhereNothingChangesForMinutes) {
  PixelShift shift;

  for (int second = 0; second < 301; ++second) shift.advance(1, false);
  EXPECT_EQ(shift.at(), (PixelOffset{1, 0}));
}

TEST(PixelShift, GoesRoundByOnePixelAtATime) {
  PixelShift shift;
  std::set<std::pair<int, int>> places;
  for (int step = 0; step < 32; ++step) {
    const PixelOffset before = shift.at();
    shift.advance(61, true);
    const PixelOffset now = shift.at();

    EXPECT_EQ(std::abs(now.x - before.x) + std::abs(now.y - before.y), 1);
    EXPECT_TRUE(now.x >= 0 && now.x <= 4 && now.y >= 0 && now.y <= 4);
    places.emplace(now.x, now.y);
  }
  EXPECT_EQ(places.size(), 16U);
  EXPECT_EQ(shift.at(), PixelOffset{});
}

}  // namespace
}  // namespace docent::kiosk::pixel_shift_test
