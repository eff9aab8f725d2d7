#include "runtime/update/update.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "platform/sqlite/content_reader.h"
#include "tests/support/release_maker.h"
#include "tests/support/run_program.h"

namespace docent::update::update_test {
namespace {

namespace fs = std::filesystem;
using release::Manifest;
using release::Time;
using testing::HasSubstr;

constexpr Time noon = 1'700'000'000, day = 86400;

/// A device beside a folder in which releases are published.
class ADevice : public testing::Test {
 protected:
  ADevice() {
    fs::create_directories(maker_.folder);
    fs::create_directories(settings_.store.database.parent_path());
  }

  Manifest manifest(std::uint64_t version) const {
    return {.version = version,
            .issued = noon + static_cast<Time>(version),
            .expires = noon + 30 * day};
  }
  /// Publishes a release whose museum is called after its number.
  void publish(std::uint64_t version) const {
    Manifest made = manifest(version);
    maker_.add(made, test::signed_museum(std::to_string(version), maker_.key));
    maker_.publish(made);
  }
  Result<Outcome> look(Time now = noon + 1000) const { return update(settings_, now); }
  std::string refusal(Time now = noon + 1000) const {
    const auto outcome = look(now);
    return outcome ? "was not refused: " + outcome->sentence : outcome.error().what;
  }
  /// What the kiosk would show.
  std::string shown() const {
    const auto museum = sqlite::load_museum(settings_.store.database);
    return museum ? museum->title.at("en") : museum.error().what;
  }
  std::size_t kept() const {
    const auto folder = settings_.store.database.parent_path() / "releases";
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
  }

  test::TemporaryFolder folder_;
  test::ReleaseMaker maker_{folder_.path() / "server"};
  Settings settings_{.store = {folder_.path() / "device/museum.db"},
                     .source = {(folder_.path() / "server").string()},
                     .keys = {signature::public_key(maker_.key)},
                     .device = {.program = "0.1.0", .schema = schema::version, .group = {}}};
};

TEST_F(ADevice, TakesAReleaseAndThenTheNext) {
  publish(1);
  ASSERT_EQ(look().value().status, "taken");
  EXPECT_EQ(shown(), "1");

  publish(2);
  EXPECT_EQ(look().value().status, "taken");
  EXPECT_EQ(shown(), "2");
  EXPECT_EQ(look().value().status, "current");
}

TEST_F(ADevice, KeepsTheLastThree) {
  for (std::uint64_t version = 1; version <= 6; ++version) {
    publish(version);
    ASSERT_TRUE(look().has_value());
  }

  EXPECT_EQ(kept(), 3U);
}

TEST_F(ADevice, GoesBackAndDoesNotTakeTheBadOneAgain) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  publish(2);
  ASSERT_TRUE(look().has_value());

  EXPECT_THAT(go_back(settings_, noon + 1001).value().sentence,
              HasSubstr("went back from release 2 to release 1"));

  EXPECT_EQ(shown(), "1");
  EXPECT_EQ(look().value().status, "went_back");
  EXPECT_EQ(shown(), "1");
  publish(3);
  EXPECT_EQ(look().value().status, "taken");
  EXPECT_EQ(shown(), "3");
  EXPECT_EQ(go_back(settings_, noon + 1002).value().release, 1U) << "2 is not returned to either";
  const auto no_more = go_back(settings_, noon + 1003);
  ASSERT_FALSE(no_more.has_value());
  EXPECT_THAT(no_more.error().what, HasSubstr("there is no release before 1"));
  EXPECT_EQ(shown(), "1");
}

TEST_F(ADevice, GoesBackByItselfWhereTheKioskStartsThreeTimes) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  publish(2);
  ASSERT_TRUE(look(noon + 2000).has_value());

  EXPECT_EQ(prepare_start(settings_, noon + 2010).value().status, "current");
  EXPECT_EQ(prepare_start(settings_, noon + 2020).value().status, "current");
  EXPECT_EQ(shown(), "2");
  EXPECT_EQ(prepare_start(settings_, noon + 2030).value().status, "back");

  EXPECT_EQ(shown(), "1");
  EXPECT_EQ(look(noon + 2100).value().status, "went_back");
}

TEST_F(ADevice, RefusesWhatAnotherKeySigned) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  const test::ReleaseMaker thief{maker_.folder};
  Manifest forged = manifest(2);
  thief.add(forged, test::signed_museum("forged", thief.key));
  thief.publish(forged);

  EXPECT_THAT(refusal(), HasSubstr("release.txt: is signed with another key"));
  EXPECT_EQ(shown(), "1");
}

TEST_F(ADevice, RefusesADatabaseThatAnotherKeySigned) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  Manifest made = manifest(2);
  maker_.add(made, test::signed_museum("2", signature::make_key()));
  maker_.publish(made);

  EXPECT_THAT(refusal(), HasSubstr("is signed with another key"));
  EXPECT_EQ(shown(), "1");
  EXPECT_EQ(look().value().status, "went_back") << "fetched once, not every hour";
}

TEST_F(ADevice, RefusesFilesOfOneReleaseInAnother) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  Manifest made = manifest(2);
  maker_.add(made, test::signed_museum("2", maker_.key));
  maker_.publish(made);
  write::replace_file(maker_.folder / made.files[0].name, test::signed_museum("9", maker_.key));

  EXPECT_THAT(refusal(), HasSubstr("is not the file that its release lists"));
  EXPECT_EQ(shown(), "1");
  fs::remove(maker_.folder / made.files[0].name);
  EXPECT_THAT(refusal(), HasSubstr("is not there, though its release lists it"));
  EXPECT_EQ(kept(), 1U) << "left something half fetched";
}

TEST_F(ADevice, DoesNotFetchWhatItCouldNotShow) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  Manifest made = manifest(2);
  maker_.add(made, test::signed_museum("2", maker_.key));
  made.files[0].size = std::uint64_t{4} << 30U;
  maker_.publish(made);

  EXPECT_THAT(refusal(), HasSubstr("holds a database of 4096 MB, and the most that a kiosk shows"));
  EXPECT_EQ(shown(), "1");
}

TEST_F(ADevice, RefusesToGoBackInTimeAndGoesOnShowing) {
  publish(1);
  const std::string old = test::text_of(maker_.folder / release::manifest_name);
  publish(2);
  ASSERT_TRUE(look().has_value());
  std::ofstream(maker_.folder / release::manifest_name) << old;
  EXPECT_THAT(refusal(), HasSubstr("release 1 is older than release 2"));

  publish(3);
  EXPECT_THAT(refusal(noon + 31 * day), HasSubstr("expired on"));
  EXPECT_THAT(refusal(noon - 365 * day), HasSubstr("nothing is taken until its clock is right"));
  EXPECT_EQ(shown(), "2");
}

TEST_F(ADevice, SaysWhatItCannotReadOrWrite) {
  publish(1);
  Settings nowhere = settings_;
  nowhere.store.database = folder_.path() / "nowhere/museum.db";
  const auto unwritten = update(nowhere, noon + 1000);
  ASSERT_FALSE(unwritten.has_value());
  EXPECT_THAT(unwritten.error().what, HasSubstr("update.lock: cannot be written (No such file"));

  fs::remove(maker_.folder / release::manifest_name);
  fs::create_symlink(release::manifest_name, maker_.folder / release::manifest_name);
  EXPECT_THAT(refusal(), HasSubstr("release.txt: cannot be looked at (Too many levels"));
}

TEST_F(ADevice, WhoseServerIsAwayShowsWhatItHas) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  fs::remove_all(maker_.folder);

  EXPECT_THAT(refusal(), HasSubstr("release.txt: there is no release"));
  EXPECT_EQ(shown(), "1");
}

TEST_F(ADevice, FetchesTheSameBytesOnce) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  Manifest again = manifest(2);
  maker_.add(again, test::signed_museum("1", maker_.key));
  maker_.publish(again);
  fs::remove(maker_.folder / again.files[0].name);

  EXPECT_EQ(look().value().status, "taken") << "though the server has not got it any more";
  EXPECT_EQ(shown(), "1");
}

TEST_F(ADevice, ChangesProgramAndDatabaseTogether) {
  Manifest both = manifest(1);
  maker_.add(both, test::signed_museum("1", maker_.key));
  std::vector<std::byte> newer = test::signed_museum("1, newer", maker_.key);
  newer[63] = std::byte{schema::version + 1};  // the last byte of user_version
  maker_.add(both, newer, schema::version + 1);
  maker_.publish(both);
  ASSERT_TRUE(look().has_value());
  EXPECT_EQ(kept(), 2U);

  // The newer program finds the older database. (It would verify its own; this one cannot.)
  fs::remove(settings_.store.database);
  write::replace_file(settings_.store.database, newer);
  const auto started = prepare_start(settings_, noon + 2 * day);

  EXPECT_EQ(started.value().status, "changed") << "back to the one that this program can show";
  EXPECT_EQ(shown(), "1");
}

TEST_F(ADevice, ShowsAgainWhatWasRemovedByHand) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  fs::remove(settings_.store.database);

  ASSERT_TRUE(prepare_start(settings_, noon + 5 * day).has_value());

  EXPECT_EQ(shown(), "1");
}

TEST_F(ADevice, TellsItsReleasesToPrometheus) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  publish(2);
  ASSERT_TRUE(look().has_value());
  ASSERT_TRUE(go_back(settings_, noon + 1001).has_value());

  const std::string text = test::text_of(settings_.store.database.parent_path() / "update.prom");

  EXPECT_THAT(text, HasSubstr("\ndocent_release_shown 1\n"));
  EXPECT_THAT(text, HasSubstr("\ndocent_release_seen 2\n"));
  EXPECT_THAT(text, HasSubstr("\ndocent_release_went_back{release=\"2\"} 1\n"));
}

TEST_F(ADevice, WhoseStateIsDamagedSaysSoAndShowsWhatItHas) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  std::ofstream(settings_.store.database.parent_path() / "update.state") << "rubbish";

  EXPECT_THAT(refusal(), HasSubstr("update.state: is damaged"));
  EXPECT_EQ(shown(), "1");
}

}  // namespace
}  // namespace docent::update::update_test
