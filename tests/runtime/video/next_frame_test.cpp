#include "runtime/video/next_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

namespace docent::video::next_frame_test {
namespace {

/// Twenty-five a second, of which every so-manieth is a key frame.
std::vector<Frame> frames_with_keys(std::uint32_t count, std::uint32_t a_key_every) {
  std::vector<Frame> frames;
  for (std::uint32_t i = 0; i < count; ++i)
    frames.push_back({.milliseconds = 40 * i, .is_key = i % a_key_every == 0});
  return frames;
}

/// When each frame that is seen is there, by a machine that takes so long for each; and which.
struct Seen {
  std::uint32_t at = 0, frame = 0;  ///< Milliseconds; of the video too.
};
std::vector<Seen> seen_where_one_takes(const std::vector<Frame>& frames, std::uint32_t took) {
  std::vector<Seen> all;
  std::uint32_t now = 0, seen = 0;
  for (std::size_t next = 0; next < frames.size() && now < frames.back().milliseconds;) {
    now = std::max(now, frames[next].milliseconds);  // nothing is seen before it is due
    const NextFrame one = next_frame(frames, next, now, seen);
    if (one.is_seen) seen = now;
    now += took;
    if (one.is_seen) all.push_back({now, frames[one.index].milliseconds});
    next = one.index + 1;
  }
  return all;
}

RC_GTEST_PROP(NextFrameProperty, EachFrameIsSeenWhereThereIsTime, ()) {
  const auto frames = frames_with_keys(100, *rc::gen::inRange(1U, 200U));

  const auto seen = seen_where_one_takes(frames, *rc::gen::inRange(0U, 40U));

  RC_ASSERT(seen.size() + 1 >= frames.size());
}

RC_GTEST_PROP(NextFrameProperty, ASlowMachineShowsWhatItHasTwiceASecondAtLeast, ()) {
  const auto took = *rc::gen::inRange(41U, 200U);
  const auto frames = frames_with_keys(500, *rc::gen::inRange(1U, 600U));

  const std::vector<Seen> seen = seen_where_one_takes(frames, took);

  std::uint32_t before = 0;
  for (const Seen& one : seen) {
    RC_ASSERT(one.at - before <= 300 + 2 * took);
    before = one.at;
  }
  RC_ASSERT(!seen.empty());
}

RC_GTEST_PROP(NextFrameProperty, ASlowMachineIsNoFartherBehindThanAKeyFrame, ()) {
  const auto a_key_every = *rc::gen::inRange(1U, 100U);
  const auto took = *rc::gen::inRange(41U, 200U);
  const auto frames = frames_with_keys(500, a_key_every);

  // While the frames from one key frame to the next are decoded, others come to be due.
  for (const Seen& one : seen_where_one_takes(frames, took))
    RC_ASSERT(one.at - one.frame <= a_key_every * std::max(40U, took) + took);
}

TEST(NextFrame, BeginsInTheMiddleWithTheLastKeyFrameThatIsDue) {
  const auto frames = frames_with_keys(100, 30);

  const NextFrame first = next_frame(frames, 0, 40 * 65, 40 * 65);
  EXPECT_EQ(first.index, 60U);
  EXPECT_FALSE(first.is_seen) << "five others follow";
  const NextFrame last = next_frame(frames, 65, 40 * 65, 40 * 65);
  EXPECT_EQ(last.index, 65U);
  EXPECT_TRUE(last.is_seen);
}

}  // namespace
}  // namespace docent::video::next_frame_test
