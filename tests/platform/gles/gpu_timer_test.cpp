#include "platform/gles/gpu_timer.h"

#include <GLES3/gl3.h>
#include <gmock/gmock.h>

#include "platform/headless/headless_display.h"

namespace docent::gles::gpu_timer_test {
namespace {

// A driver that keeps no time answers nothing, which is right too; a time that is told is one.
TEST(GpuTimer, TellsNoMoreTimesThanFramesAndNoneBelowZero) {
  auto display = headless::open_headless({64, 64});
  ASSERT_TRUE(display.has_value()) << display.error().what;
  GpuTimer timer;

  constexpr int frames = 20;  // more than are kept in flight
  int told = 0;
  for (int i = 0; i < frames; ++i) {
    timer.begin();
    glClear(GL_COLOR_BUFFER_BIT);
    timer.end();
    glFinish();
    while (const auto time = timer.take()) {
      EXPECT_GE(time->count(), 0);
      ++told;
    }
  }

  EXPECT_LE(told, frames);
  EXPECT_EQ(timer.take(), std::nullopt);
}

}  // namespace
}  // namespace docent::gles::gpu_timer_test
