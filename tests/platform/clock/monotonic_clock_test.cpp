#include <gtest/gtest.h>

#include <thread>

#include "platform/clock/monotonic_clock.h"

namespace docent::clock {
namespace {

TEST(FrameClock, MeasuresTheTimeSinceTheLastFrame) {
  FrameClock clock;
  clock.since_last_frame();
  const auto before = monotonic_now();

  std::this_thread::sleep_for(std::chrono::milliseconds(5));

  const float measured = clock.since_last_frame().count();
  EXPECT_GE(measured, 0.005F);
  EXPECT_LE(measured, std::chrono::duration<float>(monotonic_now() - before).count() + 0.001F);
}

TEST(FrameClock, NeverLeapsByMoreThanATenthOfASecond) {
  FrameClock clock;

  std::this_thread::sleep_for(std::chrono::milliseconds(130));

  EXPECT_EQ(clock.since_last_frame().count(), 0.1F);
}

}  // namespace
}  // namespace docent::clock
