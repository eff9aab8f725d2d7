#include <gtest/gtest.h>

#include <thread>

#include "platform/clock/monotonic_clock.h"

namespace docent::clock {
namespace {

TEST(FrameClock, MeasuresTheTimeSinceTheLastFrame) {
  using Seconds = std::chrono::duration<float>;
  FrameClock clock;
  const auto before = monotonic_now();
  clock.since_last_frame();

  std::this_thread::sleep_for(std::chrono::milliseconds(5));

  const Seconds measured = clock.since_last_frame();
  EXPECT_GE(measured, std::chrono::milliseconds(5));
  EXPECT_LE(measured, Seconds(monotonic_now() - before));
}

TEST(FrameClock, NeverLeapsByMoreThanATenthOfASecond) {
  FrameClock clock;

  std::this_thread::sleep_for(std::chrono::milliseconds(130));

  EXPECT_EQ(clock.since_last_frame().count(), 0.1F);
}

}  // namespace
}  // namespace docent::clock
