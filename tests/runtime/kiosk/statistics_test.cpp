#include "runtime/kiosk/statistics.h"

#include <gmock/gmock.h>

#include "runtime/kiosk/allocations.h"
#include "runtime/kiosk/edges.h"

namespace docent::kiosk::statistics_test {
namespace {

using namespace std::chrono_literals;

TEST(Durations, KnowTheirPercentilesWithinTwoPercent) {
  Durations durations;
  for (int i = 1; i <= 1000; ++i) durations.add(i * 10us);

  EXPECT_NEAR(durations.milliseconds_at(0.5), 5, 0.12);
  EXPECT_NEAR(durations.milliseconds_at(0.99), 9.9, 0.25);
  EXPECT_DOUBLE_EQ(durations.longest_milliseconds(), 10);
}

TEST(Durations, AreZeroBeforeAnything) {
  EXPECT_EQ(Durations().milliseconds_at(0.5), 0);
}

TEST(Statistics, HaveEveryKeyOfTheContract) {
  const std::string json = to_json({});
  for (const char* key :
       {"frames", "frame_cpu_ms", "gl_ms", "input_to_frame_ms", "gpu_ms", "p50", "p99", "max",
        "allocations_in_frames", "rss_mb", "anonymous_mb", "start_to_first_frame_ms", "touches",
        "routes", "collisions", "dropped_frames", "video_frames", "video_frames_dropped",
        "video_decode_ms"})
    EXPECT_THAT(json, testing::HasSubstr('"' + std::string(key) + "\":"));
}

TEST(Statistics, CountEveryFrameThatAScreenMissed) {
  constexpr double rate = 60;
  EXPECT_EQ(missed_frames(16ms, rate), 0U);
  EXPECT_EQ(missed_frames(17ms, rate), 0U);
  EXPECT_EQ(missed_frames(33ms, rate), 1U);
  EXPECT_EQ(missed_frames(1s, rate), 59U);
  EXPECT_EQ(missed_frames(-1s, rate), 0U);
}

TEST(Allocations, AreCountedOnTheThreadThatMakesThem) {
  const Allocations before = allocations_on_this_thread();
  std::vector<int> memory(100);
  const Allocations after = allocations_on_this_thread();

  EXPECT_EQ(after.all - before.all, 1U);
  EXPECT_EQ(memory.size(), 100U);
}

TEST(Contact, IsWhereTheVisitorSeesItWhicheverWayTheScreenHangs) {
  const input::Contact top_left{1, 0, 0};

  EXPECT_EQ(turned(top_left, Rotation::Quarter).x, 1);
  EXPECT_EQ(turned(top_left, Rotation::Quarter).y, 0);
  EXPECT_EQ(turned(top_left, Rotation::Half).x, 1);
  EXPECT_EQ(turned(top_left, Rotation::Half).y, 1);
  EXPECT_EQ(turned(top_left, Rotation::ThreeQuarters).x, 0);
  EXPECT_EQ(turned(top_left, Rotation::ThreeQuarters).y, 1);
}

}  // namespace
}  // namespace docent::kiosk::statistics_test
