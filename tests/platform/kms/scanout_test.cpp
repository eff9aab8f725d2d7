#include "platform/kms/scanout.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cerrno>
#include <functional>

namespace docent::kms::scanout_test {
namespace {

using std::chrono::nanoseconds;
using namespace std::chrono_literals;

constexpr nanoseconds start = 100s;

/// One whose screen shows a picture and waits for the next.
Scanout showing(nanoseconds now = start) {
  Scanout s;
  looked(s, true, now);
  committed(s, CommitResult::Taken, now);
  flipped(s);
  return s;
}

TEST(Scanout, LooksForAScreenBeforeItDraws) {
  Scanout s;

  EXPECT_EQ(next_step(s, start), ScanoutStep::LookAgain);
  looked(s, true, start);
  EXPECT_EQ(next_step(s, start), ScanoutStep::Draw);
  EXPECT_EQ(commit_kind(s, start), CommitKind::SetMode);
}

TEST(Scanout, HasOneFrameInFlightAndThenFlips) {
  Scanout s = showing();

  EXPECT_EQ(commit_kind(s, start), CommitKind::Flip);
  committed(s, CommitResult::Taken, start);
  EXPECT_EQ(next_step(s, start + 5ms), ScanoutStep::AwaitFlip);
  flipped(s);
  EXPECT_EQ(next_step(s, start + 6ms), ScanoutStep::Draw);
}

TEST(Scanout, GivesUpAFlipAfterASecondAndSetsTheModeAnew) {
  Scanout s = showing();
  committed(s, CommitResult::Taken, start);

  EXPECT_EQ(next_step(s, start + 1s), ScanoutStep::GiveUpFlip);
  gave_up_flip(s);
  EXPECT_EQ(next_step(s, start + 1s), ScanoutStep::Draw);
  EXPECT_EQ(commit_kind(s, start + 1s), CommitKind::SetMode);
}

TEST(Scanout, TriesABusyCardAgainWithinAFrameAndForcesItAfterASecond) {
  Scanout s = showing();
  committed(s, CommitResult::Busy, start);

  EXPECT_EQ(next_step(s, start + 1ms), ScanoutStep::Rest);
  EXPECT_EQ(next_step(s, start + 10ms), ScanoutStep::Draw);
  EXPECT_EQ(commit_kind(s, start + 10ms), CommitKind::Flip);
  EXPECT_EQ(commit_kind(s, start + 1s), CommitKind::SetModePatient);
}

TEST(Scanout, LooksAtOnceForAnotherScreenWhenAPictureIsRefused) {
  Scanout s = showing();
  committed(s, CommitResult::Refused, start);

  EXPECT_EQ(next_step(s, start), ScanoutStep::LookAgain);
  looked(s, true, start);
  EXPECT_EQ(next_step(s, start), ScanoutStep::Draw);
  EXPECT_EQ(commit_kind(s, start), CommitKind::SetMode);
}

TEST(Scanout, DoesNotHurryWhenItIsRefusedTimeAndAgain) {
  Scanout s = showing();
  committed(s, CommitResult::Refused, start);
  looked(s, true, start);
  committed(s, CommitResult::Refused, start + 10ms);

  EXPECT_EQ(next_step(s, start + 20ms), ScanoutStep::Rest);
  EXPECT_EQ(next_step(s, start + 10ms + 250ms), ScanoutStep::LookAgain);
}

TEST(Scanout, LooksTwiceASecondForAScreenThatWasPulledOut) {
  Scanout s = showing();
  heard_hotplug(s);
  EXPECT_EQ(next_step(s, start), ScanoutStep::LookAgain);
  looked(s, false, start);

  EXPECT_EQ(next_step(s, start + 100ms), ScanoutStep::Rest);
  EXPECT_EQ(resume_at(s, start + 100ms), start + 500ms);
  EXPECT_EQ(next_step(s, start + 500ms), ScanoutStep::LookAgain);
  heard_hotplug(s);
  EXPECT_EQ(next_step(s, start + 100ms), ScanoutStep::LookAgain) << "the kernel said so";
}

TEST(Scanout, AsksForTheCardThatAnotherHasUntilItIsGranted) {
  Scanout s = showing();
  committed(s, CommitResult::NoMaster, start);

  EXPECT_EQ(next_step(s, start), ScanoutStep::TakeCard);
  asked_for_card(s, false, start);
  EXPECT_EQ(next_step(s, start + 100ms), ScanoutStep::Rest);
  EXPECT_EQ(next_step(s, start + 250ms), ScanoutStep::TakeCard);
  asked_for_card(s, true, start + 250ms);
  EXPECT_EQ(next_step(s, start + 250ms), ScanoutStep::LookAgain) << "nobody told us meanwhile";
  looked(s, true, start + 250ms);
  EXPECT_EQ(commit_kind(s, start + 250ms), CommitKind::SetMode);
}

TEST(Scanout, DrawsNothingWhileAnotherTerminalIsShown) {
  Scanout s = showing();
  left_console(s);

  EXPECT_EQ(next_step(s, start), ScanoutStep::Rest);
  EXPECT_EQ(next_step(s, start + 1h), ScanoutStep::Rest);
  returned_to_console(s, start + 1h);
  EXPECT_EQ(next_step(s, start + 1h), ScanoutStep::TakeCard);
}

TEST(Scanout, TurnsTheScreenOffOnceAndOnWithAModeSetting) {
  Scanout s = showing();
  want_screen(s, false);
  EXPECT_EQ(next_step(s, start), ScanoutStep::TurnOff);
  turned_off(s, CommitResult::Taken, start);
  EXPECT_EQ(next_step(s, start + 1h), ScanoutStep::Rest);

  want_screen(s, true);
  EXPECT_EQ(next_step(s, start + 1h), ScanoutStep::Draw);
  EXPECT_EQ(commit_kind(s, start + 1h), CommitKind::SetMode);
}

TEST(Scanout, KnowsWhatAnErrorOfTheKernelMeans) {
  EXPECT_EQ(result_of(0), CommitResult::Taken);
  EXPECT_EQ(result_of(EBUSY), CommitResult::Busy);
  EXPECT_EQ(result_of(EACCES), CommitResult::NoMaster);
  EXPECT_EQ(result_of(EPERM), CommitResult::NoMaster);
  EXPECT_EQ(result_of(EINVAL), CommitResult::Refused);
}

/// A card that goes its own way until `calm`: flips get lost, commits are refused, screens and
/// terminals come and go. Returns when a frame was shown after that.
nanoseconds drawn_again_after_trouble(const std::function<int(int)>& chance, nanoseconds calm) {
  Scanout s;
  bool others_have_it = false, flip_comes = true;
  nanoseconds now = start;
  for (; now < calm + 10s; now += 1ms) {
    const bool trouble = now < calm;
    if (!trouble && !s.is_here) returned_to_console(s, now);
    if (!trouble) others_have_it = false;
    if (trouble && chance(100) == 0) heard_hotplug(s);
    if (trouble && chance(400) == 0) left_console(s);
    if (trouble && !s.is_here && chance(50) == 0) returned_to_console(s, now);
    if (trouble && chance(300) == 0) others_have_it = !others_have_it;
    if (trouble && chance(300) == 0) want_screen(s, !s.is_wanted);
    if (!trouble) want_screen(s, true);
    switch (next_step(s, now)) {
      case ScanoutStep::Draw: {
        constexpr CommitResult any[]{CommitResult::Taken, CommitResult::Taken, CommitResult::Busy,
                                     CommitResult::Refused};
        committed(s,
                  others_have_it ? CommitResult::NoMaster
                  : trouble      ? any[chance(4)]
                                 : any[0],
                  now);
        flip_comes = !trouble || chance(4) != 0;
        break;
      }
      case ScanoutStep::AwaitFlip:
        if (flip_comes) {
          flipped(s);
          if (!trouble) return now;
        }
        break;
      case ScanoutStep::GiveUpFlip:
        gave_up_flip(s);
        break;
      case ScanoutStep::LookAgain:
        looked(s, !trouble || chance(2) == 0, now);
        break;
      case ScanoutStep::TakeCard:
        asked_for_card(s, !others_have_it, now);
        break;
      case ScanoutStep::TurnOff:
        turned_off(s, trouble && chance(2) == 0 ? CommitResult::Busy : CommitResult::Taken, now);
        break;
      case ScanoutStep::Rest:
        EXPECT_GT(resume_at(s, now), now);
        break;
    }
  }
  return now;
}

RC_GTEST_PROP(Scanout, DrawsAgainWithinThreeSecondsOfAnyTrouble, ()) {
  const auto chance = [state = *rc::gen::arbitrary<std::uint32_t>()](int of) mutable {
    state = state * 1664525U + 1013904223U;
    return static_cast<int>((state >> 8U) % static_cast<std::uint32_t>(of));
  };
  const nanoseconds calm = start + std::chrono::milliseconds(*rc::gen::inRange(0, 4000));

  RC_ASSERT(drawn_again_after_trouble(chance, calm) - calm < 3s);
}

}  // namespace
}  // namespace docent::kms::scanout_test
