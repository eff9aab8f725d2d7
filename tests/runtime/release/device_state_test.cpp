#include "runtime/release/device_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace docent::release::device_state_test {
namespace {

constexpr Time noon = 1'700'000'000;

DeviceState a_state() {
  return {.portion = 0.1234567890123,
          .seen = 42,
          .seen_issued = noon,
          .shown = 42,
          .shown_schema = 7,
          .is_pending = true,
          .shown_since = noon + 5,
          .starts = {noon + 6, noon + 7},
          .refused = {40},
          .kept = {{42, 7, "aa"}, {41, 7, "bb"}, {40, 7, "cc"}, {42, 8, "dd"}},
          .etag = "\"abc\""};
}

TEST(DeviceState, IsReadFromTheTextThatItIsWrittenAs) {
  EXPECT_EQ(parse_state(to_text(a_state()), "update.state"), a_state());
  EXPECT_EQ(parse_state(to_text(DeviceState{}), "update.state"), DeviceState{});
}

TEST(DeviceState, ThatIsDamagedSaysWhatToDo) {
  for (const char* text :
       {"", "docent update state 2\n", "docent update state 1\nportion 1\n",
        "docent update state 1\nseen x\n", "docent update state 1\nkept 1 2\n"}) {
    const auto state = parse_state(text, "update.state");

    ASSERT_FALSE(state.has_value()) << text;
    EXPECT_EQ(state.error().code, Errc::Damaged);
    EXPECT_THAT(state.error().what, testing::HasSubstr("update.state: is damaged; remove it"));
  }
}

TEST(AKioskThatStarts, ForTheThirdTimeWithinTenMinutesOfAnUpdateIsBetterOffWithoutIt) {
  DeviceState state{.shown = 42, .shown_since = noon};

  EXPECT_FALSE(note_start(state, noon + 10));
  EXPECT_FALSE(note_start(state, noon + 20));
  EXPECT_TRUE(note_start(state, noon + 600));
}

TEST(AKioskThatStarts, LongAfterAnUpdateIsNotCounted) {
  DeviceState state{.shown = 42, .shown_since = noon};
  for (int day = 1; day < 10; ++day) EXPECT_FALSE(note_start(state, noon + day * 86400));
  EXPECT_TRUE(state.starts.empty());

  DeviceState by_hand{.shown = 0, .shown_since = noon};
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(note_start(by_hand, noon + i));
}

TEST(TheReleaseBefore, IsTheNewestThatTheProgramShowsAndNobodyWentBackFrom) {
  DeviceState state = a_state();

  EXPECT_EQ(one_before(state, 7)->version, 41U) << "40 was gone back from";
  EXPECT_EQ(newest_kept(state, 8)->version, 42U);
  state.shown = 41;
  EXPECT_EQ(one_before(state, 7), nullptr);
}

}  // namespace
}  // namespace docent::release::device_state_test
