// Releases over HTTP, as a static server gives them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "platform/https/fetch.h"
#include "platform/sqlite/content_reader.h"
#include "runtime/update/update.h"
#include "tests/support/release_maker.h"
#include "tests/support/static_server.h"

namespace docent::update {
namespace {

namespace fs = std::filesystem;
using Mood = test::StaticServer::Mood;
using testing::HasSubstr;

constexpr release::Time noon = 1'700'000'000;

class AServer : public testing::Test {
 protected:
  AServer() { fs::create_directories(folder_.path() / "device"); }

  static fs::path made(const fs::path& folder) {
    fs::create_directories(folder);
    return folder;
  }
  void publish(std::uint64_t version) const {
    release::Manifest manifest{
        .version = version, .issued = noon + static_cast<int>(version), .expires = noon + 86400};
    maker_.add(manifest, test::signed_museum(std::to_string(version), maker_.key));
    maker_.publish(manifest);
  }
  Result<Outcome> look() const { return update(settings_, noon + 100); }
  std::string shown() const {
    const auto museum = sqlite::load_museum(settings_.store.database);
    return museum ? museum->title.at("en") : museum.error().what;
  }

  test::TemporaryFolder folder_;
  test::ReleaseMaker maker_{made(folder_.path() / "server")};
  test::StaticServer server_{maker_.folder};
  Settings settings_{.store = {folder_.path() / "device/museum.db"},
                     .source = {server_.url()},
                     .keys = {signature::public_key(maker_.key)},
                     .device = {.program = "0.1.0", .schema = schema::version, .group = {}}};
};

TEST_F(AServer, GivesAReleaseAsAFolderDoes) {
  publish(1);
  ASSERT_EQ(look().value().status, "taken");
  EXPECT_EQ(shown(), "1");
}

TEST_F(AServer, IsAskedForUnder2KilobytesWhetherAnythingHasChanged) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  const std::size_t before = server_.bytes(), requests = server_.requests();

  EXPECT_EQ(look().value().status, "current");

  EXPECT_EQ(server_.requests() - requests, 1U);
  EXPECT_LT(server_.bytes() - before, 400U);
  publish(2);
  EXPECT_EQ(look().value().status, "taken");
  EXPECT_EQ(shown(), "2");
}

TEST_F(AServer, ThatIsAwayOrBreaksOffChangesNothing) {
  publish(1);
  ASSERT_TRUE(look().has_value());
  publish(2);
  for (const Mood mood : {Mood::Away, Mood::Half}) {
    server_.set_mood(mood);
    const auto outcome = look();
    ASSERT_FALSE(outcome.has_value());
    EXPECT_EQ(outcome.error().code, Errc::Environment);
    EXPECT_THAT(outcome.error().what, HasSubstr("cannot be fetched"));
    EXPECT_EQ(shown(), "1");
  }
  server_.set_mood(Mood::Well);
  EXPECT_EQ(look().value().status, "taken");
}

TEST_F(AServer, CannotSendTheKioskToAFileOfItsOwn) {
  server_.set_mood(Mood::Redirecting);

  EXPECT_THAT(look().error().what, HasSubstr("cannot be fetched"));
}

TEST_F(AServer, ThatSendsMoreThanItShouldIsNotListenedTo) {
  write::replace_file(maker_.folder / "release.txt", std::vector<std::byte>(20'000));

  EXPECT_THAT(look().error().what, HasSubstr("it has more than 16384 bytes"));
}

TEST_F(AServer, ThatHasNoReleaseSaysSo) {
  EXPECT_THAT(look().error().what, HasSubstr("there is no release"));
}

}  // namespace
}  // namespace docent::update
