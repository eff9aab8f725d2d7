#include <gtest/gtest.h>

#include <thread>

#include "platform/clock/monotonic_clock.h"

namespace docent::clock::monotonic_clock_test {
namespace {

TEST(FrameClock, MeasuresTheTimeSinceTheLastFrame) {
  FrameClock clock;
  const auto before = monotonic_now();
  clock.since_last_frame();

  std::this_thread::sleep_for(std::chrono::milliseconds(5));

  const auto measured = clock.since_last_frame();
  EXPECT_GE(measured, std::chrono::milliseconds(5));
  EXPECT_LE(measured, monotonic_now() - before);
}

}  // namespace
}  // namespace docent::clock::monotonic_clock_test
