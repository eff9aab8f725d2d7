#include "runtime/kiosk/time_for_video.h"

#include <gtest/gtest.h>

namespace docent::kiosk::time_for_video_test {
namespace {

void draw(TimeForVideo& time, int frames, double milliseconds) {
  for (int frame = 0; frame < frames; ++frame) time.took(milliseconds / 1000);
}

TEST(TimeForVideo, IsThereUntilFramesOfBodiesAreSlow) {
  TimeForVideo time;
  draw(time, 100, 16.7);
  EXPECT_FALSE(time.is_short());
  draw(time, 100, 33.3);
  EXPECT_FALSE(time.is_short()) << "thirty a second";

  draw(time, 4, 110);
  EXPECT_TRUE(time.is_short());
}

TEST(TimeForVideo, IsThereBesideAFrameThatIsHeldUp) {
  TimeForVideo time;
  for (int i = 0; i < 100; ++i) {
    draw(time, 3, 400);
    draw(time, 1, 16.7);
  }
  EXPECT_FALSE(time.is_short());
}

TEST(TimeForVideo, IsThereAgainWhereSomethingElseWasSlow) {
  TimeForVideo time;
  draw(time, 4, 110);
  draw(time, 3, 16.7);
  EXPECT_TRUE(time.is_short());
  draw(time, 1, 16.7);
  EXPECT_FALSE(time.is_short());
}

}  // namespace
}  // namespace docent::kiosk::time_for_video_test
