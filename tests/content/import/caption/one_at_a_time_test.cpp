#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "content/import/caption/webvtt.h"

namespace docent::import::one_at_a_time_test {
namespace {

using ::testing::ElementsAre;

TEST(CaptionsOneAtATime, AreThoseOfTheFileInTheOrderOfTime) {
  EXPECT_THAT(one_at_a_time({{3000, 4000, "B", 6}, {1000, 2000, "A", 3}}),
              ElementsAre(TimedCaption{1000, 2000, "A", 3}, TimedCaption{3000, 4000, "B", 6}));
}

TEST(CaptionsOneAtATime, AreReadTogetherWhereTheyOverlap) {
  EXPECT_THAT(one_at_a_time({{2000, 5000, "B", 6}, {1000, 3000, "A", 3}}),
              ElementsAre(TimedCaption{1000, 2000, "A", 3}, TimedCaption{2000, 3000, "A\nB", 0},
                          TimedCaption{3000, 5000, "B", 6}));
}

RC_GTEST_PROP(CaptionsOneAtATime, SayAtEachTimeWhatTheFileSays, ()) {
  const auto time = [] { return *rc::gen::inRange<std::uint32_t>(0, 40); };
  std::vector<TimedCaption> captions;
  for (int i = *rc::gen::inRange(0, 8); i > 0; --i) {
    const std::uint32_t begin = time();
    const auto letter = static_cast<char>('a' + i);
    captions.push_back({begin, begin + 1 + time(), std::string(1, letter), 1});
  }
  const auto single = one_at_a_time(captions);

  for (std::size_t i = 0; i + 1 < single.size(); ++i)
    RC_ASSERT(single[i].end <= single[i + 1].begin);
  for (std::uint32_t at = 0; at < 90; ++at) {
    std::vector<char> expected, seen;
    for (const TimedCaption& one : captions)
      if (one.begin <= at && at < one.end) expected.push_back(one.text[0]);
    for (const TimedCaption& one : single)
      if (one.begin <= at && at < one.end)
        for (const char c : one.text)
          if (c != '\n') seen.push_back(c);
    std::ranges::sort(expected);
    std::ranges::sort(seen);
    RC_ASSERT(seen == expected);
  }
}

}  // namespace
}  // namespace docent::import::one_at_a_time_test
