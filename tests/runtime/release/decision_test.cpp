#include "runtime/release/decision.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace docent::release::decision_test {
namespace {

using testing::HasSubstr;

constexpr Time hour = 3600, day = 24 * hour, noon = 1'700'000'000;

/// A kiosk that shows release 41 of 41 and is offered 42, made at noon.
class AKiosk : public testing::Test {
 protected:
  Result<Answer> asked(Time now = noon + hour) const {
    return decide(manifest_, health_, state_, device_, now);
  }
  std::string refusal(Time now = noon + hour) const {
    const auto answer = asked(now);
    return answer ? "was not refused" : answer.error().what;
  }

  Manifest manifest_{.version = 42,
                     .issued = noon,
                     .expires = noon + 30 * day,
                     .files = {{7, 100, std::string(64, 'a'), "museum.db"}}};
  std::optional<Health> health_;
  DeviceState state_{.portion = 0.5, .seen = 41, .seen_issued = noon - day, .shown = 41};
  Device device_{.program = "0.1.0", .schema = 7, .group = {}};
};

TEST_F(AKiosk, TakesAReleaseThatIsNewAndForIt) {
  EXPECT_EQ(asked(), Answer::Take);

  state_.shown = state_.seen = 42;
  EXPECT_EQ(asked(), Answer::Current);
}

TEST_F(AKiosk, RefusesAnOlderReleaseThanOneThatItHasSeen) {
  state_.seen = 43;

  EXPECT_THAT(refusal(), HasSubstr("release 42 is older than release 43"));
}

TEST_F(AKiosk, RefusesAnOlderManifestOfTheSameRelease) {
  state_.seen = 42;
  state_.seen_issued = noon + 1;

  EXPECT_THAT(refusal(), HasSubstr("the manifest of release 42 is older"));
}

TEST_F(AKiosk, RefusesAReleaseThatHasExpired) {
  EXPECT_EQ(asked(noon + 30 * day), Answer::Take);
  EXPECT_THAT(refusal(noon + 30 * day + 1), HasSubstr("expired on"));
}

TEST_F(AKiosk, WhoseClockIsWrongByAYearTakesNothing) {
  EXPECT_THAT(refusal(noon - 365 * day), HasSubstr("nothing is taken until its clock is right"));
  EXPECT_THAT(refusal(noon + 365 * day), HasSubstr("or set the clock"));
  EXPECT_EQ(asked(noon - 200), Answer::Take) << "a clock may be a little slow";
}

TEST_F(AKiosk, OfAnotherGroupLeavesItAlone) {
  manifest_.groups = {"foyer", "cafe"};
  EXPECT_EQ(asked(), Answer::OtherGroup);

  device_.group = "cafe";
  EXPECT_EQ(asked(), Answer::Take);
}

TEST_F(AKiosk, WaitsUntilTheRolloutComesToIt) {
  manifest_.rollout = {.start = noon, .hours = 10};

  EXPECT_EQ(asked(noon - 100), Answer::NotYet);
  EXPECT_EQ(asked(noon + 5 * hour), Answer::NotYet);
  EXPECT_EQ(asked(noon + 5 * hour + 1), Answer::Take);
  state_.portion = 0.999999;
  EXPECT_EQ(asked(noon + 10 * hour), Answer::Take);
}

TEST_F(AKiosk, WithoutContentWaitsForNoRollout) {
  manifest_.rollout = {.start = noon, .hours = 10};
  state_.shown = 0;

  EXPECT_EQ(asked(noon + 1), Answer::Take);
}

TEST_F(AKiosk, DoesNotTakeAgainWhatItWentBackFrom) {
  state_.refused = {42};

  EXPECT_EQ(asked(), Answer::WentBack);
}

TEST_F(AKiosk, StopsARolloutAtTwoPercentThatWentBack) {
  manifest_.rollout = {.start = noon - 10 * hour, .hours = 10};
  health_ = Health{.version = 42, .taken = 200, .back = 3};
  EXPECT_EQ(asked(), Answer::Take);

  health_->back = 4;
  EXPECT_EQ(asked(), Answer::Stopped);
  health_->version = 41;
  EXPECT_EQ(asked(), Answer::Take) << "that was another release";
}

TEST_F(AKiosk, OfAFewIsNotStoppedByOneThatFails) {
  EXPECT_FALSE(is_stopped({.version = 42, .taken = 10, .back = 1}, 42));
  EXPECT_TRUE(is_stopped({.version = 42, .taken = 10, .back = 2}, 42));
}

TEST_F(AKiosk, LeavesAWithdrawnReleaseAtOnce) {
  manifest_.halted = {41};
  manifest_.rollout = {.start = noon, .hours = 1000};
  EXPECT_EQ(asked(), Answer::Take) << "it shows 41, which was withdrawn";

  manifest_.halted = {42};
  EXPECT_EQ(asked(), Answer::Stopped);
}

TEST_F(AKiosk, WithAnOlderProgramSaysWhatItNeeds) {
  manifest_.program = "0.10.0";
  EXPECT_THAT(refusal(), HasSubstr("is for docent 0.10.0 and newer, and this is 0.1.0"));

  manifest_.program = "0.1";
  EXPECT_EQ(asked(), Answer::Take);
  device_.schema = 8;
  EXPECT_THAT(refusal(), HasSubstr("holds no database of schema version 8"));
}

TEST(Health, IsReadFromItsTwoLines) {
  const auto health = parse_health("docent health 1\nrelease 42 taken 512 back 3\n");

  ASSERT_TRUE(health.has_value());
  EXPECT_EQ(health->taken, 512U);
  for (const char* wrong : {"", "docent health 1\n", "docent health 1\nrelease 42 taken 1 back 2\n",
                            "docent health 2\nrelease 42 taken 2 back 1\n", "<html>"})
    EXPECT_FALSE(parse_health(wrong)) << wrong;
}

}  // namespace
}  // namespace docent::release::decision_test
