// A thousand kiosks and one folder of releases. Each reads, verifies and decides as a kiosk does;
// what it takes is noted instead of stored. Every fiftieth asks a real server. A visit every hour,
// and time is a value.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "platform/signature/signed_text.h"
#include "runtime/release/decision.h"
#include "runtime/update/source.h"
#include "tests/support/release_maker.h"
#include "tests/support/static_server.h"

namespace docent::update::fleet_test {
namespace {

using release::Answer;
using release::DeviceState;
using release::Manifest;
using release::Time;

constexpr Time hour = 3600, day = 24 * hour, year = 365 * day, noon = 1'700'000'000;
constexpr std::size_t kiosks = 1000, every = 50;

struct Kiosk {
  DeviceState state;
  Time clock_is_off = 0;
  std::uint64_t before = 0;  ///< What it goes back to.
};

class AFleet : public testing::Test {
 protected:
  AFleet() {
    std::mt19937 random(7);
    for (Kiosk& kiosk : fleet_)
      kiosk.state = {.portion = std::uniform_real_distribution<double>(0, 1)(random),
                     .seen = 1,
                     .seen_issued = noon - day,
                     .shown = 1};
  }

  void publish(const Manifest& manifest) {
    maker_.publish(manifest);
    text_ = test::text_of(maker_.folder / release::manifest_name);
  }
  static Manifest manifest(std::uint64_t version, Time issued, std::uint64_t hours = 0) {
    return {.version = version,
            .issued = issued,
            .expires = issued + 30 * day,
            .rollout = {.start = issued, .hours = hours},
            .files = {{7, 1, std::string(64, 'a'), "museum.db"}}};
  }

  Result<Answer> asked(std::size_t i, Time now) const {
    std::string bytes = text_;
    if (i % every == 0) {
      const auto fetched = fetch_text(source_, release::manifest_name, release::largest_manifest);
      if (!fetched) return std::unexpected(fetched.error());
      bytes = fetched->bytes;
    } else if (is_away_) {
      return std::unexpected(Error{Errc::Environment, "away"});
    }
    const auto text =
        signature::read_signed_text(bytes, signature::Purpose::Release, keys_, "fleet");
    if (!text) return std::unexpected(text.error());
    const auto offered = release::parse_manifest(*text, "fleet");
    if (!offered) return std::unexpected(offered.error());
    return release::decide(*offered, health_, fleet_[i].state, device_,
                           now + fleet_[i].clock_is_off);
  }

  /// Every kiosk looks once; those that take a bad release go back from it. Then whoever publishes
  /// counts.
  void pass_an_hour(Time now, std::uint64_t offered, double failing = 0) {
    std::mt19937 random(static_cast<unsigned>(now));
    for (std::size_t i = 0; i < kiosks; ++i) {
      Kiosk& kiosk = fleet_[i];
      const auto answer = asked(i, now);
      if (!answer || *answer != Answer::Take) continue;
      kiosk.before = std::exchange(kiosk.state.shown, offered);
      kiosk.state.seen = offered;
      ++taken_;
      if (std::uniform_real_distribution<double>(0, 1)(random) >= failing) continue;
      kiosk.state.refused.push_back(offered);
      kiosk.state.shown = kiosk.before;
      ++back_;
    }
    health_ = release::Health{.version = offered, .taken = taken_, .back = back_};
  }
  std::size_t showing(std::uint64_t version) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        fleet_, [&](const Kiosk& kiosk) { return kiosk.state.shown == version; }));
  }
  void take_server_away(bool away) {
    is_away_ = away;
    server_.set_mood(away ? test::StaticServer::Mood::Away : test::StaticServer::Mood::Well);
  }

  test::TemporaryFolder folder_;
  test::ReleaseMaker maker_{folder_.path()};
  const std::vector<signature::PublicKey> keys_{signature::public_key(maker_.key)};
  test::StaticServer server_{folder_.path()};
  Source source_{server_.url()};
  release::Device device_{.program = "0.1.0", .schema = 7, .group = {}};
  std::vector<Kiosk> fleet_{kiosks};
  std::string text_;
  std::optional<release::Health> health_;
  std::uint64_t taken_ = 0, back_ = 0;
  bool is_away_ = false;
};

TEST_F(AFleet, TakesAReleaseEvenlyOverItsRollout) {
  publish(manifest(2, noon, 24));
  for (int i = 1; i <= 24; ++i) {
    pass_an_hour(noon + i * hour, 2);

    EXPECT_NEAR(static_cast<double>(showing(2)), kiosks * i / 24.0, 50) << "after hour " << i;
  }
  EXPECT_EQ(showing(2), kiosks);
  EXPECT_GT(server_.requests(), 400U);
}

TEST_F(AFleet, StopsAReleaseThatMakesEveryKioskGoBack) {
  publish(manifest(2, noon, 100));
  for (int i = 1; i <= 20; ++i) pass_an_hour(noon + i * hour, 2, 1.0);

  EXPECT_EQ(showing(1), kiosks);
  EXPECT_LE(taken_, kiosks * 2 / 100) << "how many visitors' kiosks it has cost three starts";
  publish(manifest(3, noon + 21 * hour));
  health_.reset();
  pass_an_hour(noon + 22 * hour, 3);
  EXPECT_EQ(showing(3), kiosks);
}

TEST_F(AFleet, StopsAReleaseThatMakesOneInTwentyGoBack) {
  publish(manifest(2, noon, 24));
  for (int i = 1; i <= 26; ++i) pass_an_hour(noon + i * hour, 2, 0.05);

  EXPECT_LT(showing(2), kiosks / 4);
  EXPECT_GE(back_ * 50, taken_ - back_);
}

TEST_F(AFleet, LetsAReleaseThroughThatOneInAThousandGoesBackFrom) {
  publish(manifest(2, noon, 24));
  for (int i = 1; i <= 26; ++i) pass_an_hour(noon + i * hour, 2, 0.001);

  EXPECT_GT(showing(2), kiosks - 10);
}

TEST_F(AFleet, WhoseServerIsAwayForADayGoesOnAfterIt) {
  publish(manifest(2, noon, 24));
  for (int i = 1; i <= 6; ++i) pass_an_hour(noon + i * hour, 2);
  const std::size_t shown = showing(2);
  take_server_away(true);
  for (int i = 7; i <= 30; ++i) pass_an_hour(noon + i * hour, 2);
  EXPECT_EQ(showing(2), shown);
  EXPECT_EQ(showing(1), kiosks - shown);

  take_server_away(false);
  pass_an_hour(noon + 31 * hour, 2);
  EXPECT_EQ(showing(2), kiosks);
}

TEST_F(AFleet, WithClocksThatAreWrongByAYearGoesOnShowing) {
  for (std::size_t i = 0; i < 20; ++i) fleet_[i * 7].clock_is_off = i % 2 == 0 ? year : -year;
  publish(manifest(2, noon));
  pass_an_hour(noon + hour, 2);
  EXPECT_EQ(showing(2), kiosks - 20);
  EXPECT_EQ(showing(1), 20U);

  for (Kiosk& kiosk : fleet_) kiosk.clock_is_off = 0;
  pass_an_hour(noon + 2 * hour, 2);
  EXPECT_EQ(showing(2), kiosks);
}

TEST_F(AFleet, LeavesAWithdrawnReleaseAtOnceAndTakesNoOldOneFromAThief) {
  publish(manifest(2, noon));
  const std::string old = text_;
  pass_an_hour(noon + hour, 2);
  ASSERT_EQ(showing(2), kiosks);
  Manifest better = manifest(3, noon + 2 * hour, 1000);
  better.halted = {2};
  publish(better);
  pass_an_hour(noon + 3 * hour, 3);
  EXPECT_EQ(showing(3), kiosks);

  write::replace_file(folder_.path() / release::manifest_name, std::as_bytes(std::span(old)));
  text_ = old;
  pass_an_hour(noon + 4 * hour, 2);
  EXPECT_EQ(showing(3), kiosks);
}

}  // namespace
}  // namespace docent::update::fleet_test
